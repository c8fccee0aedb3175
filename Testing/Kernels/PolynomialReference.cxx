#include "PolynomialReference.h"

#include <algorithm>
#include <cmath>

namespace rtg::testing
{

namespace
{

template <class Number>
Number Horner(const std::vector<Number>& polynomial, Number x)
{
  Number value = 0;
  for (std::size_t i = polynomial.size(); i-- > 0;)
  {
    value = value * x + polynomial[i];
  }
  return value;
}

template <class Number>
std::vector<Number> Derivative(const std::vector<Number>& polynomial)
{
  std::vector<Number> derivative;
  for (std::size_t i = 1; i < polynomial.size(); ++i)
  {
    derivative.push_back(Number(i) * polynomial[i]);
  }
  return derivative;
}

std::vector<Quad> Product(const std::vector<Quad>& a, const std::vector<Quad>& b)
{
  std::vector<Quad> product(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      product[i + j] += a[i] * b[j];
    }
  }
  return product;
}

/// The root in a bracket: Newton's method, with bisection where that leaves it or stalls.
template <class Number>
Number Root(
  const std::vector<Number>& polynomial, const std::vector<Number>& derivative, Number low, Number high, Number least)
{
  const bool rises = Horner(polynomial, low) < 0;
  Number x = (low + high) / 2;
  for (int i = 0; i < 400 && high - low > least; ++i)
  {
    const Number value = Horner(polynomial, x);
    if (value == 0)
    {
      return x;
    }
    ((value < 0) == rises ? low : high) = x;
    const Number next = x - value / Horner(derivative, x);
    const bool inside = next > low && next < high && i % 8 != 7;
    const Number middle = (low + high) / 2;
    const Number step = inside ? next - x : middle - x;
    x = inside ? next : middle;
    if (inside && step < least && step > -least)
    {
      return x;
    }
  }
  return x;
}

/// Real roots in [low, high], in order; those of the derivatives serve as brackets.
std::vector<long double> Roots(const std::vector<long double>& polynomial, long double low, long double high)
{
  if (polynomial.size() < 2)
  {
    return {};
  }
  const std::vector<long double> derivative = Derivative(polynomial);
  std::vector<long double> brackets = Roots(derivative, low, high);
  brackets.insert(brackets.begin(), low);
  brackets.push_back(high);
  std::vector<long double> roots;
  for (std::size_t i = 0; i + 1 < brackets.size(); ++i)
  {
    const long double a = Horner(polynomial, brackets[i]), b = Horner(polynomial, brackets[i + 1]);
    if ((a < 0) != (b < 0))
    {
      roots.push_back(Root(polynomial, derivative, brackets[i], brackets[i + 1], (high - low) * 1e-19L));
    }
  }
  return roots;
}

} // namespace

PolynomialReference::PolynomialReference(std::vector<Quad> coefficients, int degree)
  : coefficients_(std::move(coefficients))
  , degree_(degree)
{
}

Quad PolynomialReference::Value(const Quad point[3], Quad gradient[3]) const
{
  std::vector<Quad> powers[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    powers[axis].assign(1, 1);
    for (int i = 0; i < this->degree_; ++i)
    {
      powers[axis].push_back(powers[axis].back() * point[axis]);
    }
  }
  Quad value = 0, sums[3] = { 0, 0, 0 };
  std::size_t at = 0;
  for (int a = this->degree_; a >= 0; --a)
  {
    for (int b = this->degree_ - a; b >= 0; --b)
    {
      const int e[3] = { a, b, this->degree_ - a - b };
      const Quad coefficient = this->coefficients_[at++];
      value += coefficient * powers[0][e[0]] * powers[1][e[1]] * powers[2][e[2]];
      for (int axis = 0; axis < 3 && gradient; ++axis)
      {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        sums[axis] += e[axis] == 0
          ? Quad(0)
          : e[axis] * coefficient * powers[axis][e[axis] - 1] * powers[u][e[u]] * powers[v][e[v]];
      }
    }
  }
  if (gradient)
  {
    std::copy_n(sums, 3, gradient);
  }
  return value;
}

std::vector<PolynomialReference::Crossing>
PolynomialReference::Crossings(const Quad origin[3], const Quad direction[3]) const
{
  // A unit direction, from the point nearest to the center
  Quad dd = 0, od = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    dd += direction[axis] * direction[axis];
    od += origin[axis] * direction[axis];
  }
  const Quad length = sqrtq(dd), start = -od / dd;
  Quad o[3], d[3], oo = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    d[axis] = direction[axis] / length;
    o[axis] = origin[axis] + start * direction[axis];
    oo += o[axis] * o[axis];
  }
  constexpr double most = 1.25; // nothing of the surface is as far away
  if (oo > most * most)
  {
    return {};
  }
  std::vector<std::vector<Quad>> powers[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    powers[axis].push_back({ 1 });
    for (int i = 0; i < this->degree_; ++i)
    {
      powers[axis].push_back(Product(powers[axis].back(), { o[axis], d[axis] }));
    }
  }
  std::vector<Quad> form(this->degree_ + 1, 0);
  std::size_t at = 0;
  for (int a = this->degree_; a >= 0; --a)
  {
    for (int b = this->degree_ - a; b >= 0; --b)
    {
      const std::vector<Quad> term = Product(Product(powers[0][a], powers[1][b]), powers[2][this->degree_ - a - b]);
      for (int i = 0; i <= this->degree_; ++i)
      {
        form[i] += this->coefficients_[at] * term[i];
      }
      ++at;
    }
  }
  std::vector<Quad> radius{ 1 };
  for (int i = 0; i <= this->degree_; ++i)
  {
    radius = Product(radius, { oo, 0, 1 });
  }
  std::vector<Quad> surface = Product(form, form);
  for (std::size_t i = 0; i < radius.size(); ++i)
  {
    surface.resize(std::max(surface.size(), radius.size()), 0);
    surface[i] = radius[i] - surface[i];
  }

  const std::vector<Quad> derivative = Derivative(surface);
  std::vector<long double> rounded(derivative.begin(), derivative.end());
  std::vector<Quad> brackets{ -Quad(most) };
  for (const long double extreme : Roots(rounded, -(long double)(most), (long double)(most)))
  {
    brackets.push_back(extreme);
  }
  brackets.push_back(most);
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i + 1 < brackets.size(); ++i)
  {
    const Quad a = Horner(surface, brackets[i]), b = Horner(surface, brackets[i + 1]);
    if ((a < 0) == (b < 0))
    {
      continue;
    }
    const Quad s = Root<Quad>(surface, derivative, brackets[i], brackets[i + 1], 1e-32);
    Quad p[3], gradient[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = o[axis] + s * d[axis];
    }
    const Quad distance = sqrtq(oo + s * s);
    const Quad value = this->Value(p, gradient), power = powq(distance, this->degree_);
    Crossing crossing{ start + s / length, {}, distance };
    for (int axis = 0; axis < 3; ++axis)
    {
      const Quad slope = (gradient[axis] - this->degree_ * value * p[axis] / (distance * distance)) / power;
      crossing.gradient[axis] = p[axis] / distance - (value < 0 ? -slope : slope);
    }
    crossings.push_back(crossing);
  }
  return crossings;
}

} // namespace rtg::testing
