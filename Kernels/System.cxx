#include "System.h"

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#elif defined(__linux__)
#include <sys/resource.h>
#endif

#include <cstdlib>

namespace rtg
{

#ifdef _WIN32

// std::getenv would give it in the system's code page.
std::filesystem::path FolderOfVariable(const char* variable)
{
  const wchar_t* value = ::_wgetenv(std::filesystem::path(variable).c_str());
  return value ? std::filesystem::path(value) : std::filesystem::path();
}

std::filesystem::path CacheFolderOfUser()
{
  return FolderOfVariable("LOCALAPPDATA");
}

void LowerPriority()
{
  ::SetThreadPriority(::GetCurrentThread(), THREAD_PRIORITY_LOWEST);
}

#else

std::filesystem::path FolderOfVariable(const char* variable)
{
  const char* value = std::getenv(variable);
  return value ? std::filesystem::path(value) : std::filesystem::path();
}

// A relative one is to be ignored, says the XDG Base Directory Specification.
std::filesystem::path CacheFolderOfUser()
{
  const std::filesystem::path base = FolderOfVariable("XDG_CACHE_HOME"), home = FolderOfVariable("HOME");
  return base.is_absolute() ? base : home.is_absolute() ? home / ".cache" : std::filesystem::path();
}

// Elsewhere than on Linux it would be that of the process.
void LowerPriority()
{
#ifdef __linux__
  ::setpriority(PRIO_PROCESS, 0, 19);
#endif
}

#endif

} // namespace rtg
