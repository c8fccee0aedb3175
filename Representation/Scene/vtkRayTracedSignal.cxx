#include "vtkRayTracedSignal.h"

#include <csignal>

namespace
{
volatile std::sig_atomic_t arrived = 0;

void Note(int)
{
  arrived = 1;
}
}

//----------------------------------------------------------------------------
vtkRayTracedSignal::vtkRayTracedSignal()
{
  Handler before = std::signal(SIGINT, Note);
  if (before == SIG_DFL || before == SIG_IGN || before == SIG_ERR || before == Note)
  {
    std::signal(SIGINT, before == SIG_ERR ? SIG_DFL : before);
    return;
  }
  arrived = 0;
  this->Before = before;
}

//----------------------------------------------------------------------------
vtkRayTracedSignal::~vtkRayTracedSignal()
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
bool vtkRayTracedSignal::Arrived() const
{
  return this->Before && arrived;
}
