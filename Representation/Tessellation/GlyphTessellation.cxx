#include "GlyphTessellation.h"

#include "Finite.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
constexpr double pi = 3.14159265358979323846;
// Facets of round shapes around their axis, and from pole to pole.
constexpr int around = 48, fromPole = 24;

struct Corner
{
  glm::dvec3 Position, Normal;
};

glm::dvec3 Unit(const glm::dvec3& v)
{
  const double length = glm::length(v);
  return rtg::IsPositive(length) ? v / length : glm::dvec3(0.0, 0.0, 1.0);
}

// A grid of corners of a function of two whole numbers, as triangles that are counter-clockwise seen from outside where
// the corners are with i to the right and j upwards. Triangles without area are left out.
void AddGrid(rtg::TriangleMesh& mesh, int columns, int rows, const std::function<Corner(int, int)>& corner)
{
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const Corner made = corner(i, j);
      mesh.positions.emplace_back(made.Position);
      mesh.normals.emplace_back(Unit(made.Normal));
    }
  }
  const auto add = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const glm::vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    if (p != q && q != r && r != p)
    {
      mesh.triangles.emplace_back(a, b, c);
    }
  };
  const auto width = static_cast<std::uint32_t>(columns + 1);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const std::uint32_t a = first + static_cast<std::uint32_t>(j) * width + static_cast<std::uint32_t>(i);
      add(a, a + 1, a + width + 1);
      add(a, a + width + 1, a + width);
    }
  }
}

// A section of the outline of a solid of revolution around x: its ends (x, radius), walked so that the outside is to
// the left where the radius is upwards and x to the right, and the normals there (along x, across).
struct Section
{
  glm::dvec2 From, To;
  glm::dvec2 NormalFrom, NormalTo;
};

void AddRevolution(rtg::TriangleMesh& mesh, const Section& section)
{
  AddGrid(mesh, around, 1,
    [&section](int i, int j)
    {
      // The same at both ends to the bit
      const double angle = 2.0 * pi * (i % around) / around;
      const double c = std::cos(angle), s = std::sin(angle);
      const glm::dvec2 at = j == 0 ? section.From : section.To, normal = j == 0 ? section.NormalFrom : section.NormalTo;
      return Corner{ { at.x, at.y * c, at.y * s }, { normal.x, normal.y * c, normal.y * s } };
    });
}

void AddDisc(rtg::TriangleMesh& mesh, double x, double radius, double side)
{
  const glm::dvec2 normal(side, 0.0), center(x, 0.0), rim(x, radius);
  AddRevolution(mesh, side < 0.0 ? Section{ center, rim, normal, normal } : Section{ rim, center, normal, normal });
}

// Of a ball with this center on the x axis, the part with angles from +x up to one.
void AddBallPart(rtg::TriangleMesh& mesh, double center, double radius, double highest)
{
  const int steps = std::max(1, static_cast<int>(std::ceil(fromPole * highest / pi)));
  for (int k = 0; k < steps; ++k)
  {
    const auto at = [&](int step)
    {
      const double angle = highest - highest * step / steps;
      const bool pole = (step == 0 && highest == pi) || step == steps;
      return glm::dvec2(std::cos(angle), pole ? 0.0 : std::sin(angle));
    };
    const glm::dvec2 from = at(k), to = at(k + 1);
    AddRevolution(mesh, { glm::dvec2(center, 0.0) + radius * from, glm::dvec2(center, 0.0) + radius * to, from, to });
  }
}

double Power(double value, double exponent)
{
  return std::copysign(std::pow(std::abs(value), exponent), value);
}

// Cosine and sine of an angle that is i / n of a revolution, exact at multiples of 90 degrees.
glm::dvec2 Circle(int i, int n)
{
  const int quarter = 4 * i / n;
  if (4 * i % n == 0)
  {
    constexpr double c[] = { 1.0, 0.0, -1.0, 0.0 };
    return { c[quarter % 4], c[(quarter + 3) % 4] };
  }
  const double angle = 2.0 * pi * i / n;
  return { std::cos(angle), std::sin(angle) };
}

// A closed surface in the frame of its half-lengths; `corner` of the cosine and sine of the angle around z and of that
// from the pole, its normal in that frame.
rtg::TriangleMesh ClosedSurface(int facets, const std::function<Corner(const glm::dvec2&, const glm::dvec2&)>& corner)
{
  rtg::TriangleMesh mesh;
  AddGrid(mesh, 2 * facets, facets,
    [&](int i, int j)
    {
      Corner made = corner(Circle(i % (2 * facets), 2 * facets), Circle(facets - j, 2 * facets));
      made.Position *= 0.5;
      return made;
    });
  return mesh;
}
}

//----------------------------------------------------------------------------
rtg::TriangleMesh rtglyphs::GlyphTessellation::Sphere(bool half)
{
  rtg::TriangleMesh mesh;
  AddBallPart(mesh, 0.0, 0.5, half ? 0.5 * pi : pi);
  return mesh;
}

//----------------------------------------------------------------------------
rtg::TriangleMesh rtglyphs::GlyphTessellation::Box()
{
  rtg::TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      AddGrid(mesh, 1, 1,
        [&](int i, int j)
        {
          glm::dvec3 normal(0.0), place;
          normal[axis] = side;
          place[axis] = 0.5 * side;
          place[(axis + 1) % 3] = side * (i - 0.5);
          place[(axis + 2) % 3] = j - 0.5;
          return Corner{ place, normal };
        });
    }
  }
  return mesh;
}

//----------------------------------------------------------------------------
rtg::TriangleMesh rtglyphs::GlyphTessellation::CutCone(double ratio, bool open)
{
  rtg::TriangleMesh mesh;
  const glm::dvec2 normal = glm::normalize(glm::dvec2(1.0 - ratio, 1.0));
  AddRevolution(mesh, { { 0.0, 1.0 }, { 1.0, ratio }, normal, normal });
  if (!open)
  {
    AddDisc(mesh, 0.0, 1.0, -1.0);
    AddDisc(mesh, 1.0, ratio, 1.0);
  }
  return mesh;
}

//----------------------------------------------------------------------------
rtg::TriangleMesh rtglyphs::GlyphTessellation::Cylinder()
{
  rtg::TriangleMesh mesh = CutCone(1.0, false);
  // From the x axis to the y axis, centered.
  for (glm::vec3& p : mesh.positions)
  {
    p = { 0.5f * p.z, p.x - 0.5f, 0.5f * p.y };
  }
  for (glm::vec3& n : mesh.normals)
  {
    n = { n.z, n.x, n.y };
  }
  return mesh;
}

//----------------------------------------------------------------------------
rtg::TriangleMesh rtglyphs::GlyphTessellation::Cone()
{
  rtg::TriangleMesh mesh;
  const glm::dvec2 side(0.5, 1.0);
  AddRevolution(mesh, { { -0.5, 0.5 }, { 0.5, 0.0 }, side, side });
  AddDisc(mesh, -0.5, 0.5, -1.0);
  return mesh;
}

//----------------------------------------------------------------------------
// Kernels/Shapes/ArrowForm.glsl has the outline: a disc, a cone that touches a ball, and the ball at the tip.
rtg::TriangleMesh rtglyphs::GlyphTessellation::ArrowHead(const rtg::ArrowForm& form)
{
  rtg::TriangleMesh mesh;
  const double radius = form.tipRadius, height = form.tipLength;
  const double a =
    double(form.tipRounding) * form.tipRounding * radius * height / (radius + std::hypot(radius, height));
  AddDisc(mesh, -height, radius, -1.0);
  if (!(a > 0.0))
  {
    const glm::dvec2 side(radius, height);
    AddRevolution(mesh, { { -height, radius }, { 0.0, 0.0 }, side, side });
    return mesh;
  }
  const double center = height - a; // from the base
  const double tangent = std::sqrt(radius * radius + center * center - a * a);
  const glm::dvec2 side =
    glm::dvec2(tangent * radius - a * center, a * radius + tangent * center) / (radius * radius + center * center);
  AddRevolution(mesh, { { -height, radius }, glm::dvec2(-a, 0.0) + a * side, side, side });
  AddBallPart(mesh, -a, a, std::atan2(side.y, side.x));
  return mesh;
}

//----------------------------------------------------------------------------
// With a unit vector d, x = |dx|^(2/r) and so on lie on the surface: |x|^r + |y|^s + |z|^t = dx^2 + dy^2 + dz^2.
rtg::TriangleMesh rtglyphs::GlyphTessellation::Superquadric(const glm::vec3& exponents, int facets)
{
  const glm::dvec3 e(exponents);
  return ClosedSurface(facets,
    [&e](const glm::dvec2& round, const glm::dvec2& polar)
    {
      const glm::dvec3 d(round.x * polar.y, round.y * polar.y, polar.x);
      Corner corner;
      glm::dvec3 logs;
      for (int axis = 0; axis < 3; ++axis)
      {
        corner.Position[axis] = Power(d[axis], 2.0 / e[axis]);
        // The gradient's e |x|^(e - 1) is e |d|^(2 - 2/e).
        logs[axis] = std::log(e[axis]) + (2.0 - 2.0 / e[axis]) * std::log(std::max(std::abs(d[axis]), 1e-12));
      }
      const double largest = std::max({ logs.x, logs.y, logs.z });
      for (int axis = 0; axis < 3; ++axis)
      {
        corner.Normal[axis] = d[axis] == 0.0 ? 0.0 : std::copysign(std::exp(logs[axis] - largest), d[axis]);
      }
      return corner;
    });
}

//----------------------------------------------------------------------------
// x = cos(th)^alpha sin(ph)^beta, y = sin(th)^alpha sin(ph)^c of the height z = cos(ph)^beta: Schultz and Kindlmann
// 2010. Its normal is across two tangents, which are taken from the neighborhood, toward the middle of each face.
rtg::TriangleMesh rtglyphs::GlyphTessellation::NestedSuperquadric(const glm::vec3& exponents, int facets)
{
  const double alpha = exponents.x, beta = exponents.y, c = exponents.z;
  const auto place = [=](const glm::dvec2& round, const glm::dvec2& polar)
  {
    const double z = Power(polar.x, beta);
    const double byX = std::pow(std::abs(polar.y), beta);
    const double byY = c == beta ? byX : std::pow(std::max(0.0, 1.0 - std::pow(std::abs(z), 2.0 / c)), 0.5 * c);
    return glm::dvec3(Power(round.x, alpha) * byX, Power(round.y, alpha) * byY, z);
  };
  return ClosedSurface(facets,
    [&](const glm::dvec2& round, const glm::dvec2& polar)
    {
      constexpr double step = 1e-3;
      const double theta = std::atan2(round.y, round.x);
      const double phi = std::clamp(std::atan2(polar.y, polar.x), 2.0 * step, pi - 2.0 * step);
      const auto tangent = [&](double dTheta, double dPhi)
      {
        const auto at = [&](double side)
        {
          const double t = theta + side * dTheta, p = phi + side * dPhi;
          return place({ std::cos(t), std::sin(t) }, { std::cos(p), std::sin(p) });
        };
        return Unit(at(1.0) - at(-1.0));
      };
      return Corner{ place(round, polar), glm::cross(tangent(0.0, step), tangent(step, 0.0)) };
    });
}

//----------------------------------------------------------------------------
// The farthest point in each direction r, in the frame where matrices are 1 + height * growth.
rtg::TriangleMesh rtglyphs::GlyphTessellation::SweptEllipsoid(const rtg::GlyphInstances& instances, std::size_t glyph)
{
  constexpr int facets = 17; // odd: none of the directions is across the way
  const glm::dvec3 size(instances.sizes3[glyph]), growth = glm::dvec3(instances.exponents3[glyph]) - 1.0;
  const glm::dvec4 after(instances.after[glyph]), before(instances.before[glyph]);
  const glm::dmat3 frame = glm::dmat3(after.z, 0, 0, after.x, 0.5 * size.y, 0, after.y, 0, 0.5 * size.z) *
    glm::mat3_cast(glm::normalize(glm::dquat(before.w, before.x, before.y, before.z)));
  const glm::dvec3 way = glm::inverse(frame) * glm::dvec3(0.5 * after.w, 0.0, 0.0);
  const glm::dvec3 axis = Unit(way);
  const glm::dquat turn = axis.z > -1.0 + 1e-12 ? glm::normalize(glm::dquat(1.0 + axis.z, -axis.y, axis.x, 0.0))
                                                : glm::dquat(0.0, 1.0, 0.0, 0.0);
  return ClosedSurface(facets,
    [&](const glm::dvec2& round, const glm::dvec2& polar)
    {
      const glm::dvec3 r = turn * glm::dvec3(round.x * polar.y, round.y * polar.y, polar.x);
      const double along = glm::dot(way, r), grows = glm::dot(growth * r, r), root = -0.5 * grows / along;
      const double height = root > 0.0 ? std::clamp((root * root - 1.0) / grows, -1.0, 1.0) : std::copysign(1.0, along);
      const glm::dvec3 squares = glm::max(1.0 + height * growth, 0.0);
      const glm::dvec3 point = height * way + squares * r / std::sqrt(glm::dot(squares * r, r));
      return Corner{ 2.0 * (frame * point), glm::transpose(glm::inverse(frame)) * r };
    });
}
