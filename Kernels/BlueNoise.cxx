#include "BlueNoise.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace rtg
{

namespace
{

// Points on a torus of cells, and at each cell the sum of Gaussians around all points: high in clusters, low in voids.
class Torus
{
public:
  explicit Torus(std::uint32_t side)
    : side_(side)
    , gaussian_(std::size_t(side) * side)
    , taken_(gaussian_.size())
    , energy_(gaussian_.size())
  {
    constexpr double sigma = 1.9; // in cells; Ulichney found 1.5 best, others up to 2
    for (std::uint32_t y = 0; y < side; ++y)
    {
      for (std::uint32_t x = 0; x < side; ++x)
      {
        const double dx = std::min(x, side - x);
        const double dy = std::min(y, side - y);
        this->gaussian_[y * side + x] = static_cast<float>(std::exp(-(dx * dx + dy * dy) / (2.0 * sigma * sigma)));
      }
    }
  }

  void Set(std::size_t cell, bool taken)
  {
    this->taken_[cell] = taken;
    const float sign = taken ? 1.0f : -1.0f;
    const std::size_t side = this->side_;
    const std::size_t cx = cell % side;
    const std::size_t cy = cell / side;
    for (std::size_t y = 0; y < side; ++y)
    {
      const float* row = &this->gaussian_[(y + side - cy) % side * side];
      for (std::size_t x = 0; x < side; ++x)
      {
        this->energy_[y * side + x] += sign * row[(x + side - cx) % side];
      }
    }
  }

  bool Taken(std::size_t cell) const { return this->taken_[cell]; }
  std::size_t TightestCluster() const { return this->Extreme(true, 1.0f); }
  std::size_t LargestVoid() const { return this->Extreme(false, -1.0f); }

private:
  std::size_t Extreme(bool taken, float sign) const
  {
    std::size_t best = 0;
    float most = -INFINITY;
    for (std::size_t i = 0; i < this->energy_.size(); ++i)
    {
      if (this->taken_[i] == taken && sign * this->energy_[i] > most)
      {
        most = sign * this->energy_[i];
        best = i;
      }
    }
    return best;
  }

  std::size_t side_;
  std::vector<float> gaussian_;
  std::vector<bool> taken_;
  std::vector<float> energy_;
};

} // namespace

std::vector<std::uint32_t> BlueNoiseTile(std::uint32_t side)
{
  const std::size_t cells = std::size_t(side) * side;
  Torus torus(side);

  // Initial points: a tenth of the cells at random, then moved from clusters to voids until none moves.
  std::mt19937 random(1);
  std::size_t points = 0;
  while (points < std::max<std::size_t>(1, cells / 10))
  {
    const std::size_t cell = random() % cells;
    if (!torus.Taken(cell))
    {
      torus.Set(cell, true);
      ++points;
    }
  }
  for (std::size_t turn = 0; turn < cells; ++turn)
  {
    const std::size_t from = torus.TightestCluster();
    torus.Set(from, false);
    const std::size_t to = torus.LargestVoid();
    torus.Set(to, true);
    if (from == to)
    {
      break;
    }
  }

  // Ranks: of the initial points by taking clusters away, of the rest by filling voids.
  std::vector<std::uint32_t> rank(cells);
  Torus rest = torus;
  for (std::size_t i = points; i-- > 0;)
  {
    const std::size_t cell = rest.TightestCluster();
    rest.Set(cell, false);
    rank[cell] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t i = points; i < cells; ++i)
  {
    const std::size_t cell = torus.LargestVoid();
    torus.Set(cell, true);
    rank[cell] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> thresholds(cells);
  for (std::size_t i = 0; i < cells; ++i)
  {
    thresholds[i] = static_cast<std::uint32_t>((2 * std::uint64_t(rank[i]) + 1) * (1ull << 31) / cells);
  }
  return thresholds;
}

} // namespace rtg
