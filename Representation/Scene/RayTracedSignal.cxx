#include "RayTracedSignal.h"

#include <csignal>

namespace
{
volatile std::sig_atomic_t arrived = 0;

void HandleInterrupt(int)
{
  arrived = 1;
}
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedSignal::RayTracedSignal()
{
  Handler before = std::signal(SIGINT, HandleInterrupt);
  if (before == SIG_DFL || before == SIG_IGN || before == SIG_ERR || before == HandleInterrupt)
  {
    std::signal(SIGINT, before == SIG_ERR ? SIG_DFL : before);
    return;
  }
  arrived = 0;
  this->Before = before;
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedSignal::~RayTracedSignal()
{
  if (this->Before)
  {
    std::signal(SIGINT, this->Before);
    if (arrived)
    {
      std::raise(SIGINT);
    }
  }
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedSignal::Arrived() const
{
  return this->Before && arrived;
}
