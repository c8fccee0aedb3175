#include "HarmonicForms.h"

#include "Glyphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace rtg
{

namespace
{

double Factorial(int n)
{
  return n < 2 ? 1.0 : n * Factorial(n - 1);
}

double Binomial(int n, int k)
{
  return k < 0 || k > n ? 0.0 : Factorial(n) / (Factorial(k) * Factorial(n - k));
}

// A homogeneous polynomial, with its coefficients as FormTerm() has them.
struct Form
{
  int degree = 0;
  std::vector<double> terms = { 1.0 };

  static Form Zero(int degree) { return { degree, std::vector<double>(FormTerms(degree), 0.0) }; }

  template <class Visit>
  void ForEach(const Visit& visit) const
  {
    for (int a = this->degree; a >= 0; --a)
    {
      for (int b = this->degree - a; b >= 0; --b)
      {
        const int c = this->degree - a - b;
        visit(a, b, c, this->terms[FormTerm(b, c)]);
      }
    }
  }
};

Form Product(const Form& p, const Form& q)
{
  Form product = Form::Zero(p.degree + q.degree);
  p.ForEach(
    [&](int, int pb, int pc, double pTerm) {
      q.ForEach([&](int, int qb, int qc, double qTerm) { product.terms[FormTerm(pb + qb, pc + qc)] += pTerm * qTerm; });
    });
  return product;
}

// (x^2 + y^2 + z^2)^power
Form SquaredRadius(int power)
{
  Form square = Form::Zero(2);
  square.terms[FormTerm(0, 0)] = square.terms[FormTerm(2, 0)] = square.terms[FormTerm(0, 2)] = 1.0;
  Form form;
  for (int i = 0; i < power; ++i)
  {
    form = Product(form, square);
  }
  return form;
}

// The real (or imaginary) part of (x + i y)^m: rho^m cos m phi (or sin m phi).
Form Azimuthal(int m, bool imaginary)
{
  Form form = Form::Zero(m);
  for (int b = imaginary ? 1 : 0; b <= m; b += 2)
  {
    form.terms[FormTerm(b, 0)] = ((b / 2) % 2 == 0 ? 1.0 : -1.0) * Binomial(m, b);
  }
  return form;
}

// r^(l-m) times the m-th derivative of Legendre's polynomial P_l at z / r.
Form Polar(int l, int m)
{
  Form form = Form::Zero(l - m);
  for (int j = 0; 2 * j <= l - m; ++j)
  {
    const int power = l - m - 2 * j;
    Form axis = Form::Zero(power);
    axis.terms[FormTerm(0, power)] = (j % 2 == 0 ? 1.0 : -1.0) * std::ldexp(1.0, -l) * Binomial(l, j) *
      Binomial(2 * l - 2 * j, l) * Factorial(l - 2 * j) / Factorial(power);
    const Form term = Product(axis, SquaredRadius(j));
    std::transform(term.terms.begin(), term.terms.end(), form.terms.begin(), form.terms.begin(), std::plus<double>());
  }
  return form;
}

// sqrt(2) (for m = 0: 1) K cos m phi or K sin m phi without the Condon-Shortley phase, times r^degree.
Form Harmonic(int l, int m, bool sine, int degree)
{
  const double norm =
    std::sqrt((m == 0 ? 1.0 : 2.0) * (2 * l + 1) / (4.0 * std::numbers::pi) * Factorial(l - m) / Factorial(l + m));
  Form form = Product(Product(Azimuthal(m, sine), Polar(l, m)), SquaredRadius((degree - l) / 2));
  for (double& term : form.terms)
  {
    term *= norm;
  }
  return form;
}

// The least even degree, up to the largest, with so many terms.
int DegreeOf(int terms)
{
  int degree = 0;
  while (degree < mostDegree && FormTerms(degree) < terms)
  {
    degree += 2;
  }
  return degree;
}

} // namespace

FormMap::FormMap(int components, int degree)
  : components_(components)
  , degree_(degree)
  , matrix_(static_cast<std::size_t>(components) * FormTerms(degree), 0.0)
{
}

bool FormMap::IsHarmonicsLength(int components)
{
  return FormTerms(DegreeOf(components)) == components;
}

bool FormMap::IsFourthOrderLength(int components)
{
  return components == 15 || components == 21 || components == 36 || components == 81;
}

FormMap FormMap::Harmonics(int components, HarmonicsBasis basis)
{
  if (!IsHarmonicsLength(components))
  {
    throw Error("Ray Traced Glyphs: spherical harmonics of " + std::to_string(components) +
      " components; give 1, 6, 15, 28, 45, 66 or 91.");
  }
  const int most = DegreeOf(components);
  FormMap map(components, std::max(most, 2));
  const bool dipy = basis == HarmonicsBasis::Dipy || basis == HarmonicsBasis::DipyLegacy;
  for (int l = 0; l <= most; l += 2)
  {
    for (int m = -l; m <= l; ++m)
    {
      // The phase is that of |m|; DIPY's newer basis takes Y of m itself, which for m < 0 has (-1)^m once more.
      const bool odd = m % 2 != 0;
      const bool phase = basis != HarmonicsBasis::Orthonormal && !(basis == HarmonicsBasis::Dipy && m < 0);
      const Form form = Harmonic(l, std::abs(m), dipy ? m > 0 : m < 0, map.degree_);
      for (int term = 0; term < FormTerms(map.degree_); ++term)
      {
        map.At(term, l * (l + 1) / 2 + m) = phase && odd ? -form.terms[term] : form.terms[term];
      }
    }
  }
  return map;
}

FormMap FormMap::NormalStress()
{
  FormMap map(6, 2);
  map.At(FormTerm(0, 0), 0) = map.At(FormTerm(2, 0), 1) = map.At(FormTerm(0, 2), 2) = 1.0;
  map.At(FormTerm(1, 0), 3) = map.At(FormTerm(1, 1), 4) = map.At(FormTerm(0, 1), 5) = 2.0;
  return map;
}

FormMap FormMap::FourthOrder(int components)
{
  if (!IsFourthOrderLength(components))
  {
    throw Error("Ray Traced Glyphs: a fourth-order tensor of " + std::to_string(components) +
      " components; give 15, 21, 36 or 81.");
  }
  FormMap map(components, 4);
  constexpr int voigt[3][3] = { { 0, 5, 4 }, { 5, 1, 3 }, { 4, 3, 2 } };
  for (int index = 0; index < 81; ++index)
  {
    const std::array<int, 4> indices = { index / 27, index / 9 % 3, index / 3 % 3, index % 3 };
    const int row = voigt[indices[0]][indices[1]], column = voigt[indices[2]][indices[3]];
    const int low = std::min(row, column), high = std::max(row, column);
    const auto count = [&indices](int axis)
    { return static_cast<int>(std::count(indices.begin(), indices.end(), axis)); };
    const int term = FormTerm(count(1), count(2));
    const int component = components == 81 ? index
      : components == 36                   ? 6 * row + column
      : components == 21                   ? low * 6 - low * (low - 1) / 2 + high - low
                                           : term;
    map.At(term, component) += 1.0;
  }
  return map;
}

void FormMap::Apply(const double* components, double* coefficients) const
{
  for (int term = 0; term < FormTerms(this->degree_); ++term)
  {
    const double* row = &this->matrix_[static_cast<std::size_t>(term) * this->components_];
    double sum = 0.0;
    for (int i = 0; i < this->components_; ++i)
    {
      sum += row[i] * components[i];
    }
    coefficients[term] = sum;
  }
}

} // namespace rtg
