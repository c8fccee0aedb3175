#include "FormExtents.h"

#include "Finite.h"
#include "HarmonicForms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace rtg
{

namespace
{

constexpr double coarseAngle = 0.5; ///< times m
constexpr int finer = 3;            ///< a side of a cell of the first grid has so many of the second

// How far a direction may be from the middle of its cell, whose sides are arcs of that length: sin^2(d / 2) =
// sin^2(dTheta / 2) + sin theta1 sin theta2 sin^2(dPhi / 2).
double Covering(double side)
{
  return 2.0 * std::asin(std::min(1.0, side / std::sqrt(8.0)));
}

glm::dvec3 Direction(double theta, double phi)
{
  return { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) };
}

// |f|, |f n_x|, |f n_y|, |f n_z|
using Sizes = std::array<double, 4>;

Sizes SizesOf(double f, const glm::dvec3& n)
{
  return { std::abs(f), std::abs(f * n.x), std::abs(f * n.y), std::abs(f * n.z) };
}

void Include(Sizes& all, const Sizes& own)
{
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    all[k] = std::max(all[k], own[k]);
  }
}

FormExtent ExtentOf(double radius, const Sizes& bounds, double rounding)
{
  FormExtent extent;
  extent.radius = radius;
  extent.bound = bounds[0] + rounding;
  for (int axis = 0; axis < 3; ++axis)
  {
    extent.reach[axis] = std::min(bounds[axis + 1] + rounding, extent.bound);
  }
  // Denormal or infinite: nothing to divide by
  const bool usable = std::isnormal(extent.bound) && std::isfinite(extent.bound) && extent.radius > 0.0;
  return usable ? extent : FormExtent();
}

} // namespace

FormMeter::FormMeter(int degree)
  : degree_(degree)
{
  const int m = degree + 1;
  const double wanted = std::sqrt(2.0) * coarseAngle / m;
  // Rings on the upper half of the sphere: f is the same on the lower one.
  const int rings = static_cast<int>(std::ceil(0.5 * std::numbers::pi / wanted));
  this->side_ = 0.5 * std::numbers::pi / rings;
  for (int ring = 0; ring < rings; ++ring)
  {
    const double theta = (ring + 0.5) * this->side_;
    const double widest = std::sin(std::min(theta + 0.5 * this->side_, 0.5 * std::numbers::pi));
    const int count = static_cast<int>(std::ceil(2.0 * std::numbers::pi * widest / this->side_));
    const double width = 2.0 * std::numbers::pi / count;
    for (int i = 0; i < count; ++i)
    {
      this->directions_.push_back(Direction(theta, width * i));
      for (int part = 0; part < finer * finer; ++part)
      {
        const double along = (part / finer + 0.5) / finer - 0.5, across = (part % finer + 0.5) / finer - 0.5;
        this->fineDirections_.push_back(Direction(theta + along * this->side_, width * (i + across)));
      }
    }
  }
  this->coarse_ = std::cos(m * Covering(this->side_));
  this->fine_ = std::cos(m * Covering(this->side_ / finer));
  const auto power = [](double x, int n) { return n == 0 ? 1.0 : std::pow(x, n); };
  for (int a = degree; a >= 0; --a)
  {
    for (int b = degree - a; b >= 0; --b)
    {
      const int c = degree - a - b;
      for (const glm::dvec3& n : this->directions_)
      {
        this->monomials_.push_back(power(n.x, a) * power(n.y, b) * power(n.z, c));
      }
      this->largest_.push_back(std::sqrt(power(a, a) * power(b, b) * power(c, c) / power(degree, degree)));
    }
  }
}

double FormMeter::Value(const double* coefficients, const glm::dvec3& n) const
{
  double sum = 0.0;
  for (int row = 0; row <= this->degree_; ++row)
  {
    double inner = 0.0, power = 1.0;
    for (int c = 0; c <= row; ++c)
    {
      inner = inner * n.y + *coefficients++ * power;
      power *= n.z;
    }
    sum = sum * n.x + inner;
  }
  return sum;
}

// Finds the maximum of |f| near a direction, by ever smaller steps.
double FormMeter::Climb(const double* coefficients, glm::dvec3 n) const
{
  double best = std::abs(this->Value(coefficients, n));
  double step = this->side_ / finer;
  for (int i = 0; i < 200 && step > 1e-4 / (this->degree_ + 1); ++i)
  {
    const glm::dvec3 axis = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(n, axis)), v = glm::cross(n, u);
    glm::dvec3 next = n;
    for (const glm::dvec3& tangent : { u, v, u + v, u - v })
    {
      for (const double side : { -step, step })
      {
        const glm::dvec3 tried = glm::normalize(n + side * tangent);
        const double value = std::abs(this->Value(coefficients, tried));
        if (value > best)
        {
          best = value;
          next = tried;
        }
      }
    }
    step *= next == n ? 0.4 : 1.0;
    n = next;
  }
  return best;
}

// A polynomial's bounds by the first grid.
struct FormMeter::Samples
{
  double rounding = 0.0; ///< a few roundings of sums; 0: there is nothing to measure
  std::vector<double> values;
  Sizes most{}, bounds{}; ///< of the values, and certain ones
  std::size_t top = 0;    ///< where |f| is largest
};

FormMeter::Samples FormMeter::Sample(const double* coefficients) const
{
  Samples samples;
  double scale = 0.0;
  for (int term = 0; term < FormTerms(this->degree_); ++term)
  {
    scale = std::isfinite(coefficients[term]) ? std::max(scale, std::abs(coefficients[term])) : INFINITY;
  }
  if (!IsPositive(scale))
  {
    return samples;
  }
  const std::size_t count = this->directions_.size();
  samples.rounding = 1e-12 * scale * FormTerms(this->degree_);
  std::vector<double>& values = samples.values;
  values.resize(count, 0.0);
  for (int term = 0; term < FormTerms(this->degree_); ++term)
  {
    const double coefficient = coefficients[term];
    const double* monomial = &this->monomials_[term * count];
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i] += coefficient * monomial[i];
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Sizes own = SizesOf(values[i], this->directions_[i]);
    samples.top = own[0] > samples.most[0] ? i : samples.top;
    Include(samples.most, own);
  }
  // Nothing is more than the middle of the values and what they differ from that, either.
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double simple = 0.5 * std::abs(*highest + *lowest) + 0.5 * (*highest - *lowest) / this->coarse_;
  for (std::size_t k = 0; k < samples.most.size(); ++k)
  {
    samples.bounds[k] = std::min(samples.most[k] / this->coarse_, simple);
  }
  return samples;
}

FormExtent FormMeter::MeasureRoughly(const double* coefficients) const
{
  const Samples samples = this->Sample(coefficients);
  return ExtentOf(samples.most[0], samples.bounds, samples.rounding);
}

FormExtent FormMeter::Measure(const double* coefficients) const
{
  const Samples samples = this->Sample(coefficients);
  if (!(samples.rounding > 0.0))
  {
    return FormExtent();
  }
  Sizes bounds = samples.bounds;
  glm::dvec3 top = this->directions_[samples.top];
  if (bounds[0] > 1.003 * samples.most[0])
  {
    Sizes fine{};
    for (std::size_t i = 0; i < samples.values.size(); ++i)
    {
      const Sizes own = SizesOf(samples.values[i], this->directions_[i]);
      bool may = false;
      for (std::size_t k = 0; k < own.size(); ++k)
      {
        may = may || own[k] >= samples.most[k] * this->coarse_;
      }
      for (int part = 0; may && part < finer * finer; ++part)
      {
        const glm::dvec3& n = this->fineDirections_[i * finer * finer + part];
        const Sizes finest = SizesOf(this->Value(coefficients, n), n);
        top = finest[0] > fine[0] ? n : top;
        Include(fine, finest);
      }
    }
    for (std::size_t k = 0; k < bounds.size(); ++k)
    {
      bounds[k] = std::min(bounds[k], fine[k] / this->fine_);
    }
  }
  return ExtentOf(this->Climb(coefficients, top), bounds, samples.rounding);
}

void FormMeter::Store(const double* coefficients, const FormExtent& extent, float* values) const
{
  constexpr double roundoff = 0.5 * std::numeric_limits<float>::epsilon();
  double moved = 0.0;
  for (int term = 0; term < FormTerms(this->degree_); ++term)
  {
    const double coefficient = coefficients[term] / extent.bound;
    values[3 + term] = static_cast<float>(coefficient);
    moved += roundoff * std::abs(coefficient) * this->largest_[term];
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    values[axis] = static_cast<float>((extent.reach[axis] / extent.bound + moved) * (1.0 + 4.0 * roundoff));
  }
}

} // namespace rtg
