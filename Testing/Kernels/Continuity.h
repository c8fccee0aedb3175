// Whether something that depends on a number in [0, 1] is continuous. A step that changes much is
// divided: its parts must change ever less. Across a jump one part changes as much as the whole step,
// however small the parts are.
#pragma once

#include <algorithm>
#include <vector>

namespace rtg::testing
{

/// A change of less than this fraction of its step's is no jump.
constexpr double shareOfJump = 0.2;

/// The largest change of a part of the step. Parts are its tenths; a tenth that changes `enough` is
/// divided again, down to thousandths of the step. change(from, to): a distance.
template <class Change>
double LargestPart(double from, double step, double enough, const Change& change, int levels = 3)
{
  double largest = 0.0;
  for (int i = 0; i < 10; ++i)
  {
    const double begin = from + i * step / 10;
    const double whole = change(begin, begin + step / 10);
    const bool divides = !(whole < enough) && levels > 1;
    largest = std::max(largest, divides ? LargestPart(begin, step / 10, enough, change, levels - 1) : whole);
  }
  return largest;
}

/// Equal steps through [0, 1]. Steps that change more than a tenth of what the largest one does are
/// divided.
class Sweep
{
public:
  template <class Change>
  Sweep(int steps, const Change& change)
    : step_(1.0 / steps)
  {
    std::vector<double> changes;
    for (int i = 0; i < steps; ++i)
    {
      changes.push_back(change(i * this->step_, (i + 1) * this->step_));
    }
    const auto largest = std::max_element(changes.begin(), changes.end());
    this->largest_ = *largest;
    this->at_ = double(largest - changes.begin()) * this->step_;
    for (int i = 0; i < steps; ++i)
    {
      if (changes[i] > 0.1 * this->largest_)
      {
        ++this->divided_;
        const double share = this->Share(i * this->step_, change);
        this->worstAt_ = share > this->worstShare_ ? i * this->step_ : this->worstAt_;
        this->worstShare_ = std::max(this->worstShare_, share);
      }
    }
  }

  /// How much of the change of the step from there is that of its part that changes most.
  template <class Change>
  double Share(double from, const Change& change) const
  {
    const double whole = change(from, from + this->step_);
    return LargestPart(from, this->step_, shareOfJump * whole, change) / whole;
  }

  double Largest() const { return this->largest_; }       ///< change of a step
  double At() const { return this->at_; }                 ///< where that step begins
  int Divided() const { return this->divided_; }          ///< how many steps were divided
  double WorstShare() const { return this->worstShare_; } ///< the largest Share() of these
  double WorstAt() const { return this->worstAt_; }       ///< where that step begins

private:
  double step_, largest_ = 0.0, at_ = 0.0, worstShare_ = 0.0, worstAt_ = 0.0;
  int divided_ = 0;
};

} // namespace rtg::testing
