// What the driver has compiled, kept on disk from process to process.
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

/// One file of a driver's data. It is only ever a shortcut: whatever is wrong with file or folder, there are no data,
/// and nobody hears of it.
class CacheFile
{
public:
  CacheFile() = default; ///< no cache
  /// `name`: without a folder; tells device, driver and version of this library apart. Without a folder: no cache.
  CacheFile(const std::optional<std::filesystem::path>& folder, const std::string& name);

  /// What was saved last, by any process; empty: nothing, or something else than that.
  std::vector<std::uint8_t> Load() const;

  /// Replaces what is there, at once for whoever loads it meanwhile. More than `mostBytes` are not saved. The oldest
  /// other files of the folder go as long as all together have more.
  void Save(const std::vector<std::uint8_t>& data) const;

  static constexpr std::size_t mostBytes = std::size_t(64) << 20;

private:
  std::filesystem::path path_; ///< empty: no cache
};

} // namespace rtg
