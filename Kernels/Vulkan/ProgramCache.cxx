#include "ProgramCache.h"

#include "../System.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <utility>

namespace rtg
{

namespace
{

namespace fs = std::filesystem;

// In front of the driver's data, which drivers trust: theirs is checked before it is handed to them.
struct Header
{
  char magic[8] = { 'R', 'T', 'G', 'c', 'a', 'c', 'h', 'e' };
  std::uint64_t bytes = 0;
  std::uint64_t checksum = 0;
};

// FNV-1a, eight bytes at a time.
std::uint64_t Checksum(const std::vector<std::uint8_t>& data)
{
  std::uint64_t sum = 0xcbf29ce484222325u;
  for (std::size_t at = 0; at < data.size(); at += 8)
  {
    std::uint64_t word = 0;
    std::memcpy(&word, &data[at], std::min<std::size_t>(8, data.size() - at));
    sum = (sum ^ word) * 0x100000001b3u;
    sum ^= sum >> 32;
  }
  return sum;
}

// Whether a file is one of ours, all of which begin alike: users may have named a folder that holds others.
bool IsCache(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  char magic[sizeof(Header::magic)] = {};
  return in.read(magic, sizeof(magic)) && std::memcmp(magic, Header().magic, sizeof(magic)) == 0;
}

// Removes the oldest files of ours until all of them have at most so many bytes.
void Shrink(const fs::path& folder, std::uintmax_t mostBytes, const fs::path& keep)
{
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::uintmax_t bytes = 0;
  std::error_code error;
  // Not a range-based loop: its ++ throws where a file server fails.
  for (fs::directory_iterator entry(folder, error), end; entry != end; entry.increment(error))
  {
    std::error_code none;
    const std::uintmax_t size = entry->is_regular_file(none) ? entry->file_size(none) : 0;
    if (!none && size > 0 && IsCache(entry->path()))
    {
      bytes += size;
      files.emplace_back(entry->last_write_time(none), entry->path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const auto& [time, path] : files)
  {
    if (bytes <= mostBytes)
    {
      return;
    }
    const std::uintmax_t size = fs::file_size(path, error);
    if (path != keep && fs::remove(path, error))
    {
      bytes -= std::min(bytes, size);
    }
  }
}

} // namespace

std::optional<std::filesystem::path> CacheFolder()
{
  const fs::path own = FolderOfVariable("RTGLYPHS_CACHE"), base = CacheFolderOfUser();
  if (!own.empty())
  {
    return own == "off" ? std::nullopt : std::optional(own);
  }
  return base.empty() ? std::nullopt : std::optional(base / "RayTracedGlyphs");
}

CacheFile::CacheFile(const std::optional<std::filesystem::path>& folder, const std::string& name)
  : path_(folder ? *folder / name : fs::path())
{
}

std::vector<std::uint8_t> CacheFile::Load() const
{
  std::ifstream in;
  if (!this->path_.empty())
  {
    in.open(this->path_, std::ios::binary);
  }
  Header header;
  if (!in.read(reinterpret_cast<char*>(&header), sizeof(header)) ||
    std::memcmp(header.magic, Header().magic, sizeof(header.magic)) != 0 || header.bytes > mostBytes)
  {
    return {};
  }
  std::vector<std::uint8_t> data(header.bytes);
  in.read(reinterpret_cast<char*>(data.data()), static_cast<std::streamsize>(data.size()));
  const bool whole = in && in.peek() == std::ifstream::traits_type::eof();
  return whole && Checksum(data) == header.checksum ? data : std::vector<std::uint8_t>();
}

void CacheFile::Save(const std::vector<std::uint8_t>& data) const
{
  if (this->path_.empty() || data.size() > mostBytes)
  {
    return;
  }
  std::error_code error;
  const fs::path folder = this->path_.parent_path();
  fs::create_directories(folder, error);
  fs::path beside = this->path_;
  beside += '.';
  beside += std::to_string(std::random_device()());
  bool written = false;
  {
    std::ofstream out(beside, std::ios::binary | std::ios::trunc);
    Header header;
    header.bytes = data.size();
    header.checksum = Checksum(data);
    out.write(reinterpret_cast<const char*>(&header), sizeof(header));
    out.write(reinterpret_cast<const char*>(data.data()), static_cast<std::streamsize>(data.size()));
    out.flush();
    written = out.good();
  }
  if (written)
  {
    fs::rename(beside, this->path_, error);
  }
  if (!written || error)
  {
    fs::remove(beside, error);
    return;
  }
  Shrink(folder, mostBytes, this->path_);
}

} // namespace rtg
