// Loaded before the C library (LD_PRELOAD), makes the ranks of Open MPI that wait for others sleep. By itself such a
// rank asks again without a pause and only yields in between (mpi_yield_when_idle), so it keeps a core busy that its
// test and the tests beside it need.
#include <ctime>

extern "C" __attribute__((visibility("default"))) int sched_yield() noexcept
{
  // A Show exchanges some thousand messages, so longer pauses would make tests longer.
  const timespec pause{ 0, 50'000 };
  nanosleep(&pause, nullptr);
  return 0;
}
