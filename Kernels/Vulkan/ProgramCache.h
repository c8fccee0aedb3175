// The driver's compiled programs, kept on disk from process to process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rtg
{

/// The folder of all caches: that of the environment variable RTGLYPHS_CACHE, none when it is `off`, else
/// RayTracedGlyphs in $XDG_CACHE_HOME (Windows: %LOCALAPPDATA%) or ~/.cache. None when nothing says where.
std::optional<std::filesystem::path> CacheFolder();

/// One file of a driver's data. If anything is wrong with file or folder the cache is empty,
/// without a message.
class CacheFile
{
public:
  CacheFile() = default; ///< no cache
  /// `name`: without a folder; differs by device, driver and version of this library. Without a folder: no cache.
  CacheFile(const std::optional<std::filesystem::path>& folder, const std::string& name);

  /// The data saved last, by any process; empty: none, or not readable.
  std::vector<std::uint8_t> Load() const;

  /// Replaces what is there, atomically for processes that load it. More than `mostBytes` are not saved. The oldest
  /// other files of the folder go as long as all together have more.
  void Save(const std::vector<std::uint8_t>& data) const;

  static constexpr std::size_t mostBytes = std::size_t(64) << 20;

private:
  std::filesystem::path path_; ///< empty: no cache
};

} // namespace rtg
