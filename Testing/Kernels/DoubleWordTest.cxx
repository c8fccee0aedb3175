// The error-free transformations are exact and the double-word operations as good as their papers say.
#include "Reference.h"
#include "Shapes/Shapes.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

using rtg::testing::Quad;

/// Numbers with random signs, bits and exponents of -20 .. 20.
template <class Real>
class Numbers
{
public:
  Real Next()
  {
    const double bits = double(this->engine_() >> 11) * 0x1p-53 + 0.5;
    const int exponent = int(this->engine_() % 41) - 20;
    return Real(std::ldexp(this->engine_() & 1 ? bits : -bits, exponent));
  }

private:
  std::mt19937_64 engine_{ 4 };
};

template <class Real>
class DoubleWordTest : public ::testing::Test
{
public:
  using Kernel = rtg::shapes::Kernel<Real>;
  using Word = typename Kernel::DoubleWord;

  Word NextWord()
  {
    const Real hi = this->numbers.Next();
    const Real ulp = std::abs(hi) * std::numeric_limits<Real>::epsilon();
    return Kernel::FastTwoSum(hi, ulp * this->numbers.Next() * Real(0x1p-21));
  }
  static Quad Value(const Word& w) { return Quad(w.hi) + Quad(w.lo); }
  /// |w - exact| / |exact| in units of the squared roundoff.
  static double Error(const Word& w, Quad exact)
  {
    const Quad u = std::numeric_limits<Real>::epsilon() / 2;
    return exact == 0 ? double(fabsq(Value(w)) > 0) : double(fabsq((Value(w) - exact) / exact) / (u * u));
  }

  Numbers<Real> numbers;
};

using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(DoubleWordTest, Reals);

TYPED_TEST(DoubleWordTest, TransformationsAreExact)
{
  using Kernel = typename TestFixture::Kernel;
  for (int i = 0; i < 100000; ++i)
  {
    const TypeParam a = this->numbers.Next(), b = this->numbers.Next();
    ASSERT_EQ(double(this->Value(Kernel::TwoSum(a, b)) - (Quad(a) + Quad(b))), 0.0);
    ASSERT_EQ(double(this->Value(Kernel::TwoProduct(a, b)) - Quad(a) * Quad(b)), 0.0);
  }
}

TYPED_TEST(DoubleWordTest, OperationsKeepTheirBounds)
{
  using Kernel = typename TestFixture::Kernel;
  double sum = 0, sumWord = 0, product = 0, productWord = 0, quotient = 0, quotientWord = 0, root = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const auto a = this->NextWord(), b = this->NextWord();
    const Quad x = this->Value(a), y = this->Value(b);
    // In double, 113 bits show relative errors of u^2 only when the sum does not cancel.
    if (fabsq(x + y) > fabsq(x))
    {
      sum = std::max(sum, this->Error(Kernel::Add(a, b), x + y));
      sumWord = std::max(sumWord, this->Error(Kernel::Add(a, b.hi), x + Quad(b.hi)));
    }
    product = std::max(product, this->Error(Kernel::Multiply(a, b), x * y));
    productWord = std::max(productWord, this->Error(Kernel::Multiply(a, b.hi), x * Quad(b.hi)));
    quotient = std::max(quotient, this->Error(Kernel::Divide(a, b), x / y));
    quotientWord = std::max(quotientWord, this->Error(Kernel::Divide(a, b.hi), x / Quad(b.hi)));
    const auto positive = a.hi < 0 ? Kernel::Minus(a) : a;
    root = std::max(root, this->Error(Kernel::SquareRoot(positive), sqrtq(fabsq(x))));
  }
  EXPECT_LE(sum, 3.01);
  EXPECT_LE(sumWord, 2.01);
  EXPECT_LE(product, 7.0);
  EXPECT_LE(productWord, 3.01);
  EXPECT_LE(quotient, 15.0);
  EXPECT_LE(quotientWord, 3.5);
  EXPECT_LE(root, 4.0);
}

/// Sums in which all of the leading words cancel keep their relative accuracy. 113 bits hold the exact sum
/// of four floats here, not of four doubles.
using FloatDoubleWordTest = DoubleWordTest<float>;
TEST_F(FloatDoubleWordTest, CancellationIsHarmless)
{
  for (int i = 0; i < 100000; ++i)
  {
    const auto a = this->NextWord();
    auto b = this->NextWord();
    b = Kernel::FastTwoSum(-a.hi, b.lo);
    ASSERT_LE(this->Error(Kernel::Add(a, b), this->Value(a) + this->Value(b)), 3.01);
  }
}

/// 2^a for the arguments that shapes have, and log2 a, against 113 bits.
TYPED_TEST(DoubleWordTest, PowersOfTwoAndLogarithms)
{
  using Real = TypeParam;
  using Kernel = rtg::shapes::Kernel<Real>;
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Quad worstPower = 0, worstLog = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const double u = uniform(engine);
    const auto a = Kernel::TwoSum(Real(1 - 101 * u * u * u), Real(1e-9 * uniform(engine)));
    const auto power = Kernel::Exp2(a);
    const Quad exactPower = exp2q(Quad(a.hi) + a.lo);
    const Quad errorOfPower = fabsq((Quad(power.hi) + power.lo) / exactPower - 1);
    worstPower = errorOfPower > worstPower ? errorOfPower : worstPower;

    const Real b = i % 2 ? Real(std::exp(-70 * u)) : Real(2 * u);
    const auto argument = Kernel::TwoSum(b, Real(1e-9) * b);
    const auto log = Kernel::Log2(argument);
    const Quad exactLog = logq(Quad(argument.hi) + argument.lo);
    const Quad scale = fabsq(exactLog) > 1 ? fabsq(exactLog) : Quad(1);
    const Quad errorOfLog = fabsq((Quad(log.hi) + log.lo) * logq(Quad(2)) - exactLog) / scale;
    worstLog = errorOfLog > worstLog ? errorOfLog : worstLog;
  }
  const double bound = sizeof(Real) == 4 ? 2e-14 : 1e-23;
  EXPECT_LT(double(worstPower), bound);
  EXPECT_LT(double(worstLog), bound);
  EXPECT_EQ(Kernel::Exp2(Kernel::Word(Real(-1e5))).hi, Real(0));
  EXPECT_LT(Kernel::Log2(Kernel::Word(Real(0))).hi, Real(-1e4));
}

} // namespace
