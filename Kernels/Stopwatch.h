#pragma once

#include <chrono>

namespace rtg
{

/// Wall-clock seconds since its making or the last Lap().
class Stopwatch
{
public:
  double Lap()
  {
    const auto now = Clock::now();
    const std::chrono::duration<double> passed = now - this->start_;
    this->start_ = now;
    return passed.count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

} // namespace rtg
