// The driver's data on disk: they come back as they were, or not at all; and the pipeline that uses them.
#include "Variable.h"
#include "Vulkan/ProgramCache.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <numeric>
#include <random>

#ifndef _WIN32
#include <dirent.h>
#include <dlfcn.h>

namespace
{
bool foldersFail = false;
}

// In place of the C library's, as <filesystem> calls it: the file server goes away before a folder's last entry.
extern "C" __attribute__((visibility("default"))) dirent* readdir(DIR* folder)
{
  static const auto next = reinterpret_cast<dirent* (*)(DIR*)>(::dlsym(RTLD_NEXT, "readdir"));
  dirent* const entry = next(folder);
  if (!entry && foldersFail)
  {
    errno = ESTALE;
  }
  return entry;
}
#endif

namespace
{

using rtg::testing::Variable;

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

class CacheFileTest : public ::testing::Test
{
protected:
  const fs::path folder = fs::temp_directory_path() / ("CacheFileTest." + std::to_string(std::random_device()()));
  const fs::path path = this->folder / "driver";

  ~CacheFileTest() override { fs::remove_all(this->folder); }

  static Bytes Data(std::size_t size)
  {
    Bytes data(size);
    std::iota(data.begin(), data.end(), std::uint8_t(3));
    return data;
  }

  std::size_t Files() const
  {
    return fs::exists(this->folder) ? std::size_t(std::distance(fs::directory_iterator(this->folder), {})) : 0;
  }
};

TEST_F(CacheFileTest, ComesBack)
{
  const rtg::CacheFile file(this->folder, "driver");
  EXPECT_TRUE(file.Load().empty());
  for (const std::size_t size : { 1, 7, 8, 1000, 3 })
  {
    file.Save(Data(size));
    EXPECT_EQ(rtg::CacheFile(this->folder, "driver").Load(), Data(size));
  }
  EXPECT_EQ(this->Files(), 1u) << "nothing is left beside it";
  EXPECT_TRUE(rtg::CacheFile(this->folder, "other driver").Load().empty());
}

TEST_F(CacheFileTest, DamagedOnesAreNothing)
{
  const rtg::CacheFile file(this->folder, "driver");
  file.Save(Data(1000));
  std::ifstream in(this->path, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), {});
  const auto write = [&](const std::string& text) { std::ofstream(this->path, std::ios::binary) << text; };
  for (std::size_t at = 0; at < good.size(); at += at < 64 ? 1 : 97)
  {
    std::string bad = good;
    bad[at] ^= 16;
    write(bad);
    EXPECT_TRUE(file.Load().empty()) << at;
  }
  for (const std::string& bad :
    { good.substr(0, good.size() - 1), good + "x", good.substr(0, 10), std::string(), std::string("text") })
  {
    write(bad);
    EXPECT_TRUE(file.Load().empty()) << bad.size();
  }
  write(good);
  EXPECT_EQ(file.Load(), Data(1000));
}

TEST_F(CacheFileTest, WhereNothingCanBeWrittenNothingIs)
{
  rtg::CacheFile(std::nullopt, "driver").Save(Data(10));
  EXPECT_TRUE(rtg::CacheFile(std::nullopt, "driver").Load().empty());
  // A file in place of the folder stops root, too.
  fs::create_directories(this->folder);
  std::ofstream(this->path) << "a file";
  const rtg::CacheFile below(this->path, "driver");
  below.Save(Data(10));
  EXPECT_TRUE(below.Load().empty());
  // A folder in place of the file: nothing is left beside it.
  fs::create_directories(this->folder / "taken" / "full");
  const rtg::CacheFile taken(this->folder, "taken");
  taken.Save(Data(10));
  EXPECT_TRUE(taken.Load().empty());
  EXPECT_EQ(this->Files(), 2u);
}

#ifndef _WIN32
TEST_F(CacheFileTest, AFolderThatCannotBeReadIsNoFailure)
{
  const rtg::CacheFile file(this->folder, "driver");
  file.Save(Data(10));
  foldersFail = true;
  EXPECT_THROW(this->Files(), fs::filesystem_error) << "the test's readdir is not called";
  EXPECT_NO_THROW(file.Save(Data(20)));
  foldersFail = false;
  EXPECT_EQ(file.Load(), Data(20));
  EXPECT_EQ(this->Files(), 1u);
}
#endif

TEST_F(CacheFileTest, Bounded)
{
  const rtg::CacheFile file(this->folder, "new");
  file.Save(Bytes(rtg::CacheFile::mostBytes + 1));
  EXPECT_TRUE(file.Load().empty());
  const std::size_t third = rtg::CacheFile::mostBytes / 3;
  for (const char* name : { "old", "middle" })
  {
    rtg::CacheFile(this->folder, name).Save(Bytes(third));
  }
  fs::last_write_time(this->folder / "old", fs::last_write_time(this->folder / "middle") - std::chrono::hours(1));
  // The folder may be one of the user's.
  const fs::path others[] = { this->folder / "thesis.tex", this->folder / "simulation.vtk" };
  std::ofstream(others[0]) << "by hand";
  std::ofstream(others[1]) << "large";
  fs::resize_file(others[1], rtg::CacheFile::mostBytes);
  for (const fs::path& other : others)
  {
    fs::last_write_time(other, fs::last_write_time(this->folder / "old") - std::chrono::hours(1));
  }
  file.Save(Bytes(third));
  for (const fs::path& other : others)
  {
    EXPECT_TRUE(fs::exists(other)) << other;
  }
  EXPECT_FALSE(fs::exists(this->folder / "old"));
  EXPECT_TRUE(fs::exists(this->folder / "middle"));
  EXPECT_EQ(file.Load(), Bytes(third));
}

TEST_F(CacheFileTest, FoldersOfTheEnvironment)
{
#ifdef _WIN32
  const char* const cacheVariable = "LOCALAPPDATA";
#else
  const char* const cacheVariable = "XDG_CACHE_HOME";
#endif
  const fs::path root = fs::temp_directory_path().root_path(), user = root / "home" / "user";
  const Variable home("HOME", user.string().c_str());
  const Variable none(cacheVariable, nullptr), unset("RTGLYPHS_CACHE", nullptr);
  EXPECT_EQ(rtg::CacheFolder(), user / ".cache" / "RayTracedGlyphs");
  {
    const Variable base(cacheVariable, (root / "caches").string().c_str());
    EXPECT_EQ(rtg::CacheFolder(), root / "caches" / "RayTracedGlyphs");
    const Variable own("RTGLYPHS_CACHE", "elsewhere");
    EXPECT_EQ(rtg::CacheFolder(), "elsewhere");
    const Variable off("RTGLYPHS_CACHE", "off");
    EXPECT_EQ(rtg::CacheFolder(), std::nullopt);
  }
  const Variable relative(cacheVariable, "caches");
  EXPECT_EQ(rtg::CacheFolder(), user / ".cache" / "RayTracedGlyphs");
  const Variable homeless("HOME", nullptr);
  EXPECT_EQ(rtg::CacheFolder(), std::nullopt);
}

} // namespace
