#include "System.h"

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

} // namespace rtg
