// Arrays as polynomials: each basis of spherical harmonics against sums of associated Legendre functions, tensors
// against their definitions; and how far polynomials reach.
#include "FormExtents.h"
#include "Glyphs.h"
#include "HarmonicForms.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace
{

using namespace rtg;
using Long = long double;

class HarmonicFormsTest : public ::testing::Test
{
protected:
  double Uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(this->engine_); }
  glm::dvec3 UnitVector()
  {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(this->engine_), normal(this->engine_), normal(this->engine_)));
  }
  std::vector<double> Random(int count)
  {
    std::vector<double> numbers(count);
    for (double& number : numbers)
    {
      number = this->Uniform();
    }
    return numbers;
  }

  std::mt19937_64 engine_{ 11 };
};

Long Value(const std::vector<double>& form, int degree, const glm::dvec3& n)
{
  Long sum = 0;
  for (int b = 0; b <= degree; ++b)
  {
    for (int c = 0; b + c <= degree; ++c)
    {
      sum += Long(form[FormTerm(b, c)]) * std::pow(Long(n.x), degree - b - c) * std::pow(Long(n.y), b) *
        std::pow(Long(n.z), c);
    }
  }
  return sum;
}

std::vector<double> Apply(const FormMap& map, const std::vector<double>& components)
{
  std::vector<double> form(FormTerms(map.Degree()));
  map.Apply(components.data(), form.data());
  return form;
}

// P_l^m(x) with the Condon-Shortley phase, by the recurrence over l.
Long Legendre(int l, int m, Long x)
{
  Long below = 0, value = 1;
  for (int i = 1; i <= m; ++i)
  {
    value *= -(2 * i - 1) * std::sqrt(1 - x * x);
  }
  for (int n = m + 1; n <= l; ++n)
  {
    const Long next = ((2 * n - 1) * x * value - (n + m - 1) * below) / (n - m);
    below = value;
    value = next;
  }
  return value;
}

// sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) P_l^m, m >= 0
Long Normalized(int l, int m, Long x)
{
  Long factor = (2 * l + 1) / (4 * std::acos(Long(-1)));
  for (int i = l - m + 1; i <= l + m; ++i)
  {
    factor /= i;
  }
  return std::sqrt(factor) * Legendre(l, m, x);
}

// As the property GlyphHarmonicsBasis states it.
Long Harmonic(HarmonicsBasis basis, int l, int m, const glm::dvec3& n)
{
  const int order = std::abs(m);
  const Long phi = std::atan2(Long(n.y), Long(n.x)), root = m == 0 ? 1 : std::sqrt(Long(2));
  const Long k = Normalized(l, order, Long(n.z)), sign = order % 2 == 0 ? 1 : -1;
  const Long c = root * k * std::cos(order * phi), s = root * k * std::sin(order * phi);
  switch (basis)
  {
    case HarmonicsBasis::MRtrix3:
      return m < 0 ? s : c;
    case HarmonicsBasis::Dipy:
      return m < 0 ? sign * c : m == 0 ? c : s;
    case HarmonicsBasis::DipyLegacy:
      return m <= 0 ? c : s;
    default:
      return sign * (m < 0 ? s : c);
  }
}

const HarmonicsBasis bases[] = { HarmonicsBasis::MRtrix3, HarmonicsBasis::Dipy, HarmonicsBasis::DipyLegacy,
  HarmonicsBasis::Orthonormal };

TEST_F(HarmonicFormsTest, EachBasisIsTheSumOfItsHarmonics)
{
  for (const HarmonicsBasis basis : bases)
  {
    for (const int components : { 1, 6, 15, 28, 45, 66, 91 })
    {
      const FormMap map = FormMap::Harmonics(components, basis);
      const std::vector<double> coefficients = this->Random(components);
      const std::vector<double> form = Apply(map, coefficients);
      for (int i = 0; i < 50; ++i)
      {
        const glm::dvec3 n = this->UnitVector();
        Long sum = 0;
        std::size_t at = 0;
        for (int l = 0; at < coefficients.size(); l += 2)
        {
          for (int m = -l; m <= l; ++m)
          {
            sum += Long(coefficients[at++]) * Harmonic(basis, l, m, n);
          }
        }
        // Coefficients of degree 12 are rounded to doubles, and cancel some thousand times.
        EXPECT_NEAR(double(Value(form, map.Degree(), n)), double(sum), 2e-11) << int(basis) << " " << components;
      }
    }
  }
}

/// Numbers that tables have: Y_20 = sqrt(5 / pi) / 4 (3 z^2 - 1), Y_21 = -+ sqrt(15 / pi) / 2 x z, Y_22 = sqrt(15 / pi)
/// / 4 (x^2 - y^2) and so on.
TEST_F(HarmonicFormsTest, LowBandsAreThoseOfTables)
{
  const double a = 0.5 * std::sqrt(15.0 / std::numbers::pi);
  const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  const double xy = a * n.x * n.y, yz = a * n.y * n.z, xz = a * n.x * n.z, xx = 0.5 * a * (n.x * n.x - n.y * n.y),
               zz = 0.25 * std::sqrt(5.0 / std::numbers::pi) * (3.0 * n.z * n.z - 1.0),
               one = 0.5 / std::sqrt(std::numbers::pi);
  const double expected[4][6] = { { one, xy, -yz, zz, -xz, xx }, { one, xx, xz, zz, -yz, xy },
    { one, xx, -xz, zz, -yz, xy }, { one, xy, yz, zz, xz, xx } };
  for (int basis = 0; basis < 4; ++basis)
  {
    const FormMap map = FormMap::Harmonics(6, bases[basis]);
    for (int i = 0; i < 6; ++i)
    {
      std::vector<double> coefficients(6, 0.0);
      coefficients[i] = 1.0;
      EXPECT_NEAR(double(Value(Apply(map, coefficients), 2, n)), expected[basis][i], 1e-15) << basis << " " << i;
    }
  }
}

TEST_F(HarmonicFormsTest, OtherNumbersOfComponentsAreRefused)
{
  for (const int components : { 0, 2, 5, 7, 14, 16, 90, 92, 120 })
  {
    EXPECT_THROW(FormMap::Harmonics(components, HarmonicsBasis::MRtrix3), Error) << components;
    EXPECT_FALSE(FormMap::IsHarmonicsLength(components)) << components;
  }
  for (const int components : { 6, 9, 16, 35, 80 })
  {
    EXPECT_THROW(FormMap::FourthOrder(components), Error) << components;
  }
}

TEST_F(HarmonicFormsTest, NormalStress)
{
  const std::vector<double> s = this->Random(6);
  const std::vector<double> form = Apply(FormMap::NormalStress(), s);
  const glm::dvec3 n = this->UnitVector();
  const glm::dmat3 matrix(s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]);
  EXPECT_NEAR(double(Value(form, 2, n)), glm::dot(n, matrix * n), 1e-14);
}

/// One tensor in all four layouts; those with fewer components have its symmetries.
TEST_F(HarmonicFormsTest, FourthOrderTensors)
{
  const int pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 1, 2 }, { 0, 2 }, { 0, 1 } };
  const auto sum = [](const std::vector<double>& tensor, const glm::dvec3& n)
  {
    double value = 0.0;
    for (int i = 0; i < 81; ++i)
    {
      value += tensor[i] * n[i / 27] * n[i / 9 % 3] * n[i / 3 % 3] * n[i % 3];
    }
    return value;
  };
  const std::vector<double> general = this->Random(81);
  const glm::dvec3 n = this->UnitVector();
  EXPECT_NEAR(double(Value(Apply(FormMap::FourthOrder(81), general), 4, n)), sum(general, n), 1e-13);

  const std::vector<double> voigt = this->Random(36);
  std::vector<double> tensor(81), upper;
  for (int row = 0; row < 6; ++row)
  {
    for (int column = 0; column < 6; ++column)
    {
      for (int swap = 0; swap < 4; ++swap)
      {
        const int i = pairs[row][swap & 1], j = pairs[row][1 - (swap & 1)];
        const int k = pairs[column][swap >> 1], l = pairs[column][1 - (swap >> 1)];
        tensor[27 * i + 9 * j + 3 * k + l] = voigt[6 * row + column];
      }
    }
  }
  EXPECT_NEAR(double(Value(Apply(FormMap::FourthOrder(36), voigt), 4, n)), sum(tensor, n), 1e-13);

  std::vector<double> symmetric = voigt;
  for (int row = 0; row < 6; ++row)
  {
    for (int column = row; column < 6; ++column)
    {
      symmetric[6 * column + row] = symmetric[6 * row + column];
      upper.push_back(symmetric[6 * row + column]);
    }
  }
  EXPECT_NEAR(double(Value(Apply(FormMap::FourthOrder(21), upper), 4, n)),
    double(Value(Apply(FormMap::FourthOrder(36), symmetric), 4, n)), 1e-13);

  // xxxx, xxxy, xxxz, xxyy, xxyz, xxzz, xyyy, xyyz, xyzz, xzzz, yyyy, ...
  const std::vector<double> full = this->Random(15);
  double value = 0.0;
  int at = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      for (int k = j; k < 3; ++k)
      {
        for (int l = k; l < 3; ++l)
        {
          double orders = 24.0, counts[3] = { 0, 0, 0 };
          for (const int index : { i, j, k, l })
          {
            orders /= ++counts[index];
          }
          value += orders * full[at++] * n[i] * n[j] * n[k] * n[l];
        }
      }
    }
  }
  EXPECT_NEAR(double(Value(Apply(FormMap::FourthOrder(15), full), 4, n)), value, 1e-13);
}

/// The bounds hold, and are as tight as FormExtents.h says.
TEST_F(HarmonicFormsTest, ExtentsHoldAndAreTight)
{
  for (const int components : { 6, 15, 45, 91 })
  {
    const FormMap map = FormMap::Harmonics(components, HarmonicsBasis::MRtrix3);
    const FormMeter meter(map.Degree());
    for (int kind = 0; kind < 12; ++kind)
    {
      std::vector<double> coefficients = this->Random(components);
      // From nearly a ball to nothing of it
      coefficients[0] *= kind < 6 ? std::pow(10.0, kind) : 0.0;
      const std::vector<double> form = Apply(map, coefficients);
      const FormExtent extent = meter.Measure(form.data());
      double radius = 0.0;
      glm::dvec3 reach(0.0);
      for (int i = 0; i < 3000; ++i)
      {
        const glm::dvec3 n = this->UnitVector();
        const double f = std::abs(double(Value(form, map.Degree(), n)));
        radius = std::max(radius, f);
        reach = glm::max(reach, f * glm::abs(n));
      }
      EXPECT_GE(extent.radius, radius * (1.0 - 1e-6));
      EXPECT_LE(extent.radius, radius * 1.05); // of the samples
      EXPECT_GE(extent.bound, extent.radius);
      EXPECT_LE(extent.bound, 1.02 * extent.radius);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_GE(extent.reach[axis], reach[axis]);
        EXPECT_LE(extent.reach[axis], 1.06 * reach[axis]);
      }
    }
  }
}

/// z^2 has its largest value on an axis, and x^2 + y^2 on a circle: where it lies is known exactly.
TEST_F(HarmonicFormsTest, ExtentsOfKnownForms)
{
  const FormMeter meter(2);
  const double axis[] = { 0, 0, 0, 0, 0, 1 }, disc[] = { 1, 0, 0, 1, 0, 0 };
  EXPECT_NEAR(meter.Measure(axis).radius, 1.0, 1e-7);
  EXPECT_NEAR(meter.Measure(disc).radius, 1.0, 1e-7);
  EXPECT_NEAR(meter.Measure(axis).reach.x, 2.0 / std::sqrt(27.0), 0.01); // cos^2 sin at its largest
  EXPECT_NEAR(meter.Measure(disc).reach.z, 2.0 / std::sqrt(27.0), 0.01);
}

TEST_F(HarmonicFormsTest, NothingToShowHasNoExtent)
{
  const FormMeter meter(4);
  std::vector<double> form(15, 0.0);
  EXPECT_EQ(meter.Measure(form.data()).radius, 0.0);
  form[3] = NAN;
  EXPECT_EQ(meter.Measure(form.data()).radius, 0.0);
  form[3] = INFINITY;
  EXPECT_EQ(meter.Measure(form.data()).radius, 0.0);
  form[3] = 1e300;
  EXPECT_GT(meter.Measure(form.data()).radius, 1e298);
}

} // namespace
