// The reference itself, on rays whose answer is known in closed form.
#include "Reference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace rtg;
using namespace rtg::testing;

ReferenceGlyph Unit(Shape shape, glm::vec3 size = glm::vec3(1.0f), const ArrowForm& arrow = {})
{
  GlyphInstances instances;
  instances.shape = shape;
  instances.arrow = arrow;
  instances.centers = { glm::vec3(0.0f) };
  instances.sizes3 = { size };
  return ReferenceGlyph(instances, 0);
}

void ExpectCrossings(ReferenceGlyph glyph, glm::dvec3 origin, glm::vec3 direction, std::vector<double> expected)
{
  const auto crossings = glyph.Crossings(origin, direction);
  ASSERT_EQ(crossings.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(double(crossings[i].t), expected[i], 1e-15 * (1 + std::abs(expected[i])));
  }
}

// Both crossings to 30 digits.
void ExpectAllDigits(ReferenceGlyph glyph, glm::dvec3 origin, glm::vec3 direction, Quad from, Quad to)
{
  const auto crossings = glyph.Crossings(origin, direction);
  ASSERT_EQ(crossings.size(), 2u);
  EXPECT_LT(double(fabsq(crossings[0].t - from)), 1e-30) << double(from);
  EXPECT_LT(double(fabsq(crossings[1].t - to)), 1e-30) << double(to);
}

TEST(ReferenceTest, Centered)
{
  ExpectCrossings(Unit(Shape::Sphere), { -3, 0.3, 0 }, { 1, 0, 0 }, { 2.6, 3.4 });
  ExpectCrossings(Unit(Shape::Box), { -3, 0.25, 0 }, { 2, 0, 0 }, { 1.25, 1.75 });
  ExpectCrossings(Unit(Shape::Cylinder), { -3, 0.5, 0.3 }, { 1, 0, 0 }, { 2.6, 3.4 });
  ExpectCrossings(Unit(Shape::Cylinder), { -3, 0.51, 0.3 }, { 1, 0, 0 }, {});
  ExpectCrossings(Unit(Shape::Cylinder), { 0.2, 3, 0.2 }, { 0, -1, 0 }, { 2.5, 3.5 });
  // The cone's radius is 0.25 half way along x.
  ExpectCrossings(Unit(Shape::Cone), { 0, -3, 0 }, { 0, 1, 0 }, { 2.75, 3.25 });
  ExpectCrossings(Unit(Shape::Cone), { -3, 0.25, 0 }, { 1, 0, 0 }, { 2.5, 3.0 });
  // The capsule's cylinder reaches to +-0.5 along x, its ends to +-1; through a side, along it, through both ends, past
  // one.
  ExpectCrossings(Unit(Shape::Capsule), { 0.4, -3, 0.3 }, { 0, 1, 0 }, { 2.6, 3.4 });
  ExpectCrossings(Unit(Shape::Capsule), { -3, 0.3, 0 }, { 1, 0, 0 }, { 2.1, 3.9 });
  ExpectCrossings(Unit(Shape::Capsule), { 0.8, -3, 0 }, { 0, 1, 0 }, { 2.6, 3.4 });
  ExpectCrossings(Unit(Shape::Capsule), { 0.9, -3, 0.31 }, { 0, 1, 0 }, {});
  // Flattened along y: half-axes 1, 0.5 and 1 of its ends, 3 to their middles.
  ExpectCrossings(Unit(Shape::Capsule, { 6, 1, 2 }), { -5, 0, 0 }, { 1, 0, 0 }, { 1, 9 });
  ExpectCrossings(Unit(Shape::Capsule, { 6, 1, 2 }), { 3.6, -3, 0 }, { 0, 1, 0 }, { 2.6, 3.4 });
  ExpectCrossings(Unit(Shape::Capsule, { 6, 1, 2 }), { 3.6, 0, -3 }, { 0, 0, 1 }, { 2.2, 3.8 });
  ExpectCrossings(Unit(Shape::Sphere, { 2, 4, 6 }), { 0, -5, 0 }, { 0, 1, 0 }, { 3, 7 });
}

/// Roots that no double has.
TEST(ReferenceTest, KeepsAllDigits)
{
  const Quad root3 = sqrtq(3), root15 = sqrtq(15);
  const glm::vec3 x(1, 0, 0), y(0, 1, 0);
  ExpectAllDigits(Unit(Shape::Sphere), { -3, 0.25, 0 }, x, 3 - root3 / 4, 3 + root3 / 4);
  ExpectAllDigits(Unit(Shape::Cylinder), { -3, 0.25, 0.25 }, x, 3 - root3 / 4, 3 + root3 / 4);
  ExpectAllDigits(Unit(Shape::Cone), { 0, -3, 0.125 }, y, 3 - root3 / 8, 3 + root3 / 8);
  ExpectAllDigits(Unit(Shape::Capsule), { 0.25, -3, 0.25 }, y, 3 - root3 / 4, 3 + root3 / 4);
  // Balls of radius 1 and 1/2 whose middles are 2 apart: a cone whose sides have the sine 1/4.
  ExpectAllDigits(Unit(Shape::RoundCone, { 2, 2, 1 }), { 0, -3, 0 }, y, 3 - root15 / 5, 3 + root15 / 5);
  GlyphInstances ball;
  ball.shape = Shape::Superquadric;
  ball.centers = { glm::vec3(0.0f) };
  ball.sizes3 = { glm::vec3(1.0f) };
  ball.uniformExponents = glm::vec3(2.0f);
  ExpectAllDigits(ReferenceGlyph(ball, 0), { -3, 0.25, 0 }, x, 3 - root3 / 4, 3 + root3 / 4);
  const QuadVector normal = Unit(Shape::Sphere).Crossings({ -3, 0.25, 0 }, x)[0].normal;
  EXPECT_LT(double(fabsq(normal.x + root3 / 2)), 1e-30);
  EXPECT_LT(double(fabsq(normal.y - Quad(0.5))), 1e-30);
}

TEST(ReferenceTest, ArrowsAreThoseOfVtk)
{
  ArrowForm form;
  form.shaftRadius = 0.0625f;
  form.tipRadius = 0.125f;
  form.tipLength = 0.25f;
  form.tipRounding = 0.0f;
  form.fixedHeads = false;
  const ReferenceGlyph unit = Unit(Shape::Arrow, glm::vec3(1.0f), form);
  ExpectCrossings(unit, { -1, 0, 0 }, { 1, 0, 0 }, { 1, 2 });
  ExpectCrossings(unit, { 0.5, -1, 0 }, { 0, 1, 0 }, { 0.9375, 1.0625 });
  ExpectCrossings(unit, { 0.875, -1, 0 }, { 0, 1, 0 }, { 0.9375, 1.0625 });
  // Past the shaft, into the base of the head, out of its side.
  ExpectCrossings(unit, { 0, 0.09375, 0 }, { 1, 0, 0 }, { 0.75, 0.8125 });

  form.fixedHeads = true;
  form.unitLength = 2.0f;
  const ReferenceGlyph longer = Unit(Shape::Arrow, { 8, 1, 1 }, form);
  ExpectCrossings(longer, { 4, -1, 0 }, { 0, 1, 0 }, { 0.875, 1.125 });
  ExpectCrossings(longer, { 0, 0.1875, 0 }, { 1, 0, 0 }, { 7.5, 7.625 });
  const ReferenceGlyph shorter = Unit(Shape::Arrow, { 0.25f, 1, 1 }, form);
  ExpectCrossings(shorter, { 0.125, -1, 0 }, { 0, 1, 0 }, { 1 - 0.0625, 1 + 0.0625 });
}

TEST(ReferenceTest, RoundedArrowsEndWhereSharpOnesDo)
{
  for (const float rounding : { 0.0f, 0.25f, 0.5f, 1.0f })
  {
    ArrowForm form;
    form.tipRounding = rounding;
    form.fixedHeads = false;
    ExpectCrossings(Unit(Shape::Arrow, glm::vec3(1.0f), form), { -1, 0, 0 }, { 1, 0, 0 }, { 1, 2 });
  }
}

TEST(ReferenceTest, Superquadrics)
{
  const auto unit = [](glm::vec3 exponents, glm::vec3 size = glm::vec3(1.0f))
  {
    GlyphInstances instances;
    instances.shape = Shape::Superquadric;
    instances.centers = { glm::vec3(0.0f) };
    instances.sizes3 = { size };
    instances.uniformExponents = exponents;
    return ReferenceGlyph(instances, 0);
  };
  ExpectCrossings(unit(glm::vec3(2.0f)), { -3, 0.3, 0 }, { 1, 0, 0 }, { 2.6, 3.4 });
  ExpectCrossings(unit(glm::vec3(2.0f), { 2, 4, 6 }), { 0, -5, 0 }, { 0, 1, 0 }, { 3, 7 });
  // The octahedron |x| + |y| + |z| = 1/2, through a face, along an edge's plane, and past it.
  ExpectCrossings(unit(glm::vec3(1.0f)), { -3, 0.125, 0.125 }, { 1, 0, 0 }, { 2.75, 3.25 });
  ExpectCrossings(unit(glm::vec3(1.0f)), { -3, 0.25, 0 }, { 1, 0, 0 }, { 2.75, 3.25 });
  ExpectCrossings(unit(glm::vec3(1.0f)), { -3, 0.3, 0.25 }, { 1, 0, 0 }, {});
  // sqrt|2x| + sqrt|2y| = 1 at z = 0: at 2y = 1/16 it is 2x = 9/16.
  ExpectCrossings(unit(glm::vec3(0.5f)), { -3, 0.03125, 0 }, { 1, 0, 0 }, { 3 - 0.28125, 3 + 0.28125 });
  // Exponents of their own: x^2 + |y| + z^4 = 1 in the frame of the half-lengths.
  ExpectCrossings(unit({ 2, 1, 4 }), { 0.25, -3, 0.25 }, { 0, 1, 0 }, { 3 - 0.34375, 3 + 0.34375 });
}

/// Those that have a closed form: a ball, an octahedron, a double cone, and one of two profiles, R(z) = 1 - z along x
/// and (1 - z^2)^(1/2) along y.
TEST(ReferenceTest, NestedSuperquadrics)
{
  const auto unit = [](glm::vec3 exponents)
  {
    GlyphInstances instances;
    instances.shape = Shape::NestedSuperquadric;
    instances.centers = { glm::vec3(0.0f) };
    instances.sizes3 = { glm::vec3(1.0f) };
    instances.uniformExponents = exponents;
    return ReferenceGlyph(instances, 0);
  };
  const Quad root3 = sqrtq(3), root11 = sqrtq(11);
  const glm::vec3 x(1, 0, 0);
  ExpectAllDigits(unit({ 1, 1, 1 }), { -3, 0.25, 0 }, x, 3 - root3 / 4, 3 + root3 / 4);
  ExpectAllDigits(unit({ 2, 2, 2 }), { -3, 0.125, 0.125 }, x, 2.75, 3.25);
  ExpectAllDigits(unit({ 1, 2, 2 }), { -3, 0.125, 0.25 }, x, 3 - root3 / 8, 3 + root3 / 8);
  const Quad width = root11 / (8 * root3);
  ExpectAllDigits(unit({ 1, 2, 1 }), { -3, 0.125, 0.25 }, x, 3 - width, 3 + width);
}

/// The normal is smooth where the head's cone runs into its ball.
TEST(ReferenceTest, RoundedHeadIsSmooth)
{
  ArrowForm form;
  form.tipRounding = 0.85f;
  form.fixedHeads = false;
  ReferenceGlyph glyph = Unit(Shape::Arrow, glm::vec3(1.0f), form);
  QuadVector previous;
  for (int i = 0; i <= 2000; ++i)
  {
    const double x = 0.7 + 0.2999 * i / 2000;
    const auto crossings = glyph.Crossings({ x, -1, 0 }, { 0, 1, 0 });
    ASSERT_EQ(crossings.size(), 2u);
    const QuadVector n = crossings[0].normal;
    if (i > 0 && x < 0.99)
    {
      EXPECT_LT(std::abs(double(n.x - previous.x)), 0.01) << x;
    }
    previous = n;
  }
}

} // namespace
