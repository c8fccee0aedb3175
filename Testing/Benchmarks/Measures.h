// What the benchmarks measure by: processor time, and how far an image is from another.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace benchmark
{

/// Processor seconds of this process, all threads: less disturbed by other work than the wall clock.
inline double CpuSeconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The value that this share of them is below or equal to; share 0.5: the median.
inline double Quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// What has been measured in each turn: one cell of a CSV file. Of all turns of several processes the script `run`
/// takes median and quartiles.
class Measured
{
public:
  explicit Measured(std::vector<double> turns)
    : turns_(std::move(turns))
  {
  }

  /// Not a number where there was no turn.
  double Median() const { return this->turns_.empty() ? NAN : Quantile(this->turns_, 0.5); }

  Measured& operator*=(double factor)
  {
    std::transform(
      this->turns_.begin(), this->turns_.end(), this->turns_.begin(), [factor](double turn) { return turn * factor; });
    return *this;
  }

  friend std::ostream& operator<<(std::ostream& stream, const Measured& measured)
  {
    const char* before = "";
    for (const double turn : measured.turns_)
    {
      stream << before << turn;
      before = ";";
    }
    return stream;
  }

private:
  std::vector<double> turns_;
};

/// What one took over what another took in the same turn.
inline std::vector<double> Ratios(const std::vector<double>& of, const std::vector<double>& over)
{
  std::vector<double> ratios(of.size());
  std::transform(of.begin(), of.end(), over.begin(), ratios.begin(), std::divides<double>());
  return ratios;
}

/// Processor time of calls. They are taken in turns, each call for 5 ms at least in each, so that the turns of
/// one lie apart and show how the machine's speed changes while all are measured.
class Turns
{
public:
  /// The number of a call that is to be measured.
  std::size_t Add(std::function<void()> call)
  {
    this->calls_.push_back(std::move(call));
    return this->calls_.size() - 1;
  }

  void Take()
  {
    this->nanoseconds_.assign(this->calls_.size(), {});
    for (std::size_t turn = 0; turn < count; ++turn)
    {
      for (std::size_t i = 0; i < this->calls_.size(); ++i)
      {
        const double start = CpuSeconds();
        double spent = 0.0;
        int calls = 0;
        do
        {
          this->calls_[i]();
          ++calls;
          spent = CpuSeconds() - start;
        } while (spent < 0.005);
        this->nanoseconds_[i].push_back(1e9 * spent / calls);
      }
    }
  }

  /// Nanoseconds of a ray, where these calls trace so many together.
  Measured ARay(const std::vector<std::size_t>& calls, std::size_t rays) const
  {
    std::vector<double> sums(count);
    for (const std::size_t call : calls)
    {
      std::transform(sums.begin(), sums.end(), this->nanoseconds_[call].begin(), sums.begin(), std::plus<double>());
    }
    return Measured(std::move(sums)) *= 1.0 / static_cast<double>(std::max<std::size_t>(1, rays));
  }

private:
  static constexpr std::size_t count = 3;
  std::vector<std::function<void()>> calls_;
  std::vector<std::vector<double>> nanoseconds_;
};

/// A file that is to be written; throws what cannot be.
inline std::ofstream Written(const std::string& path)
{
  std::ofstream file(path);
  if (!file)
  {
    throw std::runtime_error("cannot write " + path);
  }
  return file;
}

/// Mean over pixels and channels of the squared difference.
inline double SquaredError(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const glm::dvec3 difference = glm::dvec3(a[i]) - glm::dvec3(b[i]);
    sum += glm::dot(difference, difference);
  }
  return sum / (3.0 * static_cast<double>(a.size()));
}

} // namespace benchmark
