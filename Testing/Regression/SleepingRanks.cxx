// Loaded before the C library (LD_PRELOAD), makes the ranks of Open MPI that wait for others sleep. By itself such a
// rank asks again without a pause and only yields in between (mpi_yield_when_idle), so it keeps a core busy that its
// test and the tests beside it need. And counts what ranks reduce, for tests.
#include <ctime>
#include <dlfcn.h>

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED int sched_yield() noexcept
{
  // A Show exchanges some thousand messages, so longer pauses would make tests longer.
  const timespec pause{ 0, 50'000 };
  nanosleep(&pause, nullptr);
  return 0;
}

EXPORTED long rtglyphs_reduced_values;
long rtglyphs_reduced_values = 0;

EXPORTED int MPI_Allreduce(const void* own, void* all, int count, void* type, void* operation, void* communicator)
{
  using Function = int (*)(const void*, void*, int, void*, void*, void*);
  static const auto next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "MPI_Allreduce"));
  rtglyphs_reduced_values += count;
  return next(own, all, count, type, operation, communicator);
}
