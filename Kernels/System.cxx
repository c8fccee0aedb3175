#include "System.h"

#include <cstdlib>

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#elif defined(__linux__)
#include <sys/resource.h>
#endif

namespace rtg
{

void LowerPriority()
{
#ifdef _WIN32
  ::SetThreadPriority(::GetCurrentThread(), THREAD_PRIORITY_LOWEST);
#elif defined(__linux__)
  // Elsewhere it would be that of the process.
  ::setpriority(PRIO_PROCESS, 0, 19);
#endif
}

void SetEnvironment(const char* name, const char* value)
{
#ifdef _WIN32
  ::_putenv_s(name, value);
#else
  ::setenv(name, value, 1);
#endif
}

} // namespace rtg
