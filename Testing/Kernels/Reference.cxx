#include "Reference.h"

#include "NestedReference.h"
#include "PolynomialReference.h"

#include <algorithm>

namespace rtg::testing
{
namespace
{

/// Far above the rounding of 113 bits and far below anything a float can notice.
constexpr double tolerance = 1e-26;

QuadVector ToQuad(const glm::dvec3& v)
{
  return { v.x, v.y, v.z };
}

Quad Dot(const QuadVector& a, const QuadVector& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

QuadVector At(const QuadVector& o, const QuadVector& d, Quad t)
{
  return { o.x + t * d.x, o.y + t * d.y, o.z + t * d.z };
}

/// Real roots of a t^2 + 2 b t + c.
std::vector<Quad> Roots(Quad a, Quad b, Quad c)
{
  if (a == 0)
  {
    return b == 0 ? std::vector<Quad>{} : std::vector<Quad>{ -c / (2 * b) };
  }
  Quad discriminant = b * b - a * c;
  // A line that touches may leave a negative rest of rounding.
  if (discriminant < 0 && discriminant > -Quad(1e-30) * (b * b + fabsq(a * c)))
  {
    discriminant = 0;
  }
  if (discriminant < 0)
  {
    return {};
  }
  const Quad root = sqrtq(discriminant);
  const Quad q = b < 0 ? root - b : -root - b;
  return q == 0 ? std::vector<Quad>{ 0 } : std::vector<Quad>{ q / a, c / q };
}

} // namespace

ReferenceGlyph::ReferenceGlyph(const GlyphInstances& instances, std::uint32_t index)
  : shape_(instances.shape)
  , center_(ToQuad(glm::dvec3(instances.centers[index])))
{
  const glm::vec3 size = instances.SizeOf(index);
  const glm::vec4 q = instances.rotations.empty() ? glm::vec4(0, 0, 0, 1) : instances.rotations[index];

  MakeRotation(q, this->rotation_);
  this->scale_ = ToQuad(glm::dvec3(size));
  this->size_ = std::max({ size.x, size.y, size.z });
  this->exponents_ =
    ToQuad(glm::dvec3(instances.exponents3.empty() ? instances.uniformExponents : instances.exponents3[index]));
  if (this->IsPolynomial())
  {
    const float* values = instances.polynomials[index];
    this->polynomial_.assign(values + 3, values + instances.polynomials.width);
    this->degree_ = instances.polynomialDegree;
  }
  const Quad half = 0.5;
  switch (this->shape_)
  {
    case Shape::Sphere:
      this->balls_ = { { 0, half, -half, half } };
      break;
    case Shape::Capsule:
    {
      // The unit along x is the larger diameter.
      const Quad diameter = std::max(size.y, size.z), end = half * size.x / diameter;
      this->scale_.x = diameter;
      this->size_ = std::max(double(size.x) + double(diameter), this->size_);
      this->profile_ = { { -end, half }, { end, half } };
      this->balls_ = { { -end, half, -end - half, -end }, { end, half, end, end + half } };
      this->smoothStart_ = this->smoothEnd_ = true;
      break;
    }
    case Shape::RoundCone:
      this->MakeRoundCone(size);
      break;
    case Shape::SweptEllipsoid:
      MakeRotation(instances.before[index], this->diagonal_);
      this->shear_ = ToQuad(glm::dvec3(instances.after[index]));
      this->halfWay_ = half * instances.after[index].w;
      this->half_ = { 0, half * size.y, half * size.z };
      this->exponents_ = { this->exponents_.x - 1, this->exponents_.y - 1, this->exponents_.z - 1 };
      this->scale_ = { 1, 1, 1 };
      break;
    case Shape::Cylinder:
      this->profile_ = { { -half, 0 }, { -half, half }, { half, half }, { half, 0 } };
      break;
    case Shape::Cone:
      this->profile_ = { { -half, 0 }, { -half, half }, { half, 0 } };
      break;
    case Shape::Arrow:
      this->arrow_ = instances.arrow;
      this->arrowLength_ = size.x;
      this->MakeArrow(1);
      break;
    default:
      break;
  }
}

// That of q / |q| (Shoemake 1985); columns are the turned frame's axes.
void ReferenceGlyph::MakeRotation(const glm::vec4& q, Rotation& rotation)
{
  const Quad x = q.x, y = q.y, z = q.z, w = q.w;
  const Quad n = x * x + y * y + z * z + w * w;
  const Quad rows[3][3] = {
    { w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y) },
    { 2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x) },
    { 2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z },
  };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      rotation[i][j] = rows[i][j] / n;
    }
  }
}

// The outline's straight part is the common tangent of two circles.
void ReferenceGlyph::MakeRoundCone(const glm::vec3& size)
{
  const Quad diameter = std::max(size.y, size.z), half = 0.5;
  const Quad length = size.x / diameter, end = half * length;
  const Quad first = half * size.y / diameter, last = half * size.z / diameter;
  this->scale_ = { diameter, diameter, diameter };
  this->size_ = double(diameter * (std::max(end + last, first - end) - std::min(-end - first, end - last)));
  this->size_ = std::max(this->size_, double(diameter));
  if (length <= fabsq(first - last))
  {
    const Quad middle = first > last ? -end : end;
    this->balls_ = { { middle, half, middle - half, middle + half } };
    return;
  }
  const Quad sine = (first - last) / length, cosine = sqrtq((1 - sine) * (1 + sine));
  const ProfilePoint start{ -end + first * sine, first * cosine }, finish{ end + last * sine, last * cosine };
  this->profile_ = { start, finish };
  this->balls_ = { { -end, first, -end - first, start.h }, { end, last, finish.h, end + last } };
  this->smoothStart_ = this->smoothEnd_ = true;
}

void ReferenceGlyph::MakeArrow(Quad factor)
{
  const ArrowForm& form = this->arrow_;
  const Quad length = this->arrowLength_;
  const Quad shaft = form.shaftRadius * factor;
  const Quad tip = form.tipRadius * factor;
  const Quad outwards = (factor - 1) * std::max(form.shaftRadius, form.tipRadius);
  Quad height = form.tipLength;
  Quad end = 1;
  this->balls_.clear();
  this->smoothEnd_ = false;
  if (form.fixedHeads)
  {
    const bool shrunk = length <= height * form.unitLength;
    const Quad unit = shrunk ? length / height : Quad(form.unitLength);
    this->scale_ = { unit, unit, unit };
    end = shrunk ? height : length / unit;
  }
  const bool hasShaft = shaft > 0 && end > height;
  const Quad base = end - height - outwards;
  end += outwards;
  height += 2 * outwards;
  if (hasShaft)
  {
    this->profile_ = { { -outwards, 0 }, { -outwards, shaft }, { base, shaft } };
  }
  else
  {
    this->profile_ = { { base, 0 } };
  }
  if (tip == 0)
  {
    this->profile_.push_back({ base, 0 });
  }
  else
  {
    this->profile_.push_back({ base, tip });
    if (form.tipRounding == 0)
    {
      this->profile_.push_back({ end, 0 });
    }
    else
    {
      const Quad inradius = tip * height / (tip + sqrtq(tip * tip + height * height));
      const Quad ball = Quad(form.tipRounding) * form.tipRounding * inradius;
      const Quad center = end - ball;
      // Angle at the base's rim between the axis and the line that touches the ball.
      const Quad toCenter = center - base;
      const Quad distance = sqrtq(tip * tip + toCenter * toCenter);
      const Quad angle = atan2q(tip, toCenter) - asinq(ball / distance);
      this->profile_.push_back({ center + ball * sinq(angle), ball * cosq(angle) });
      this->balls_ = { { center, ball, this->profile_.back().h, end } };
      this->smoothEnd_ = true;
    }
  }
  const Quad across = 2 * std::max(shaft, tip) * std::max(this->scale_.y, this->scale_.z);
  this->size_ = double(std::max(length, across));
}

QuadVector ReferenceGlyph::Turned(const Rotation& r, const QuadVector& v, bool toWorld)
{
  if (toWorld)
  {
    return { r[0][0] * v.x + r[0][1] * v.y + r[0][2] * v.z, r[1][0] * v.x + r[1][1] * v.y + r[1][2] * v.z,
      r[2][0] * v.x + r[2][1] * v.y + r[2][2] * v.z };
  }
  return { r[0][0] * v.x + r[1][0] * v.y + r[2][0] * v.z, r[0][1] * v.x + r[1][1] * v.y + r[2][1] * v.z,
    r[0][2] * v.x + r[1][2] * v.y + r[2][2] * v.z };
}

std::vector<ReferenceCrossing>
ReferenceGlyph::Crossings(const glm::dvec3& origin, const glm::vec3& direction, double factor)
{
  const QuadVector o = ToQuad(origin);
  const QuadVector d = ToQuad(glm::dvec3(direction));
  const QuadVector lo =
    Turned(this->rotation_, { o.x - this->center_.x, o.y - this->center_.y, o.z - this->center_.z }, false);
  const QuadVector ld = Turned(this->rotation_, d, false);
  Quad scale = factor;
  if (this->shape_ == Shape::Arrow)
  {
    this->MakeArrow(factor);
    scale = 1;
  }
  UnitRay ray;
  ray.origin = { lo.x / this->scale_.x / scale, lo.y / this->scale_.y / scale, lo.z / this->scale_.z / scale };
  ray.direction = { ld.x / this->scale_.x / scale, ld.y / this->scale_.y / scale, ld.z / this->scale_.z / scale };

  // Every t below counts from the point nearest to the glyph's origin, where digits matter most.
  const Quad start = -Dot(ray.origin, ray.direction) / Dot(ray.direction, ray.direction);
  ray.origin = At(ray.origin, ray.direction, start);

  std::vector<ReferenceCrossing> found;
  if (this->shape_ == Shape::Box)
  {
    this->MeetRectangles(ray, found);
  }
  else if (this->shape_ == Shape::Superquadric)
  {
    this->MeetSuperquadric(ray, found);
  }
  else if (this->shape_ == Shape::SweptEllipsoid)
  {
    this->MeetSweep(ray, -1, found);
    this->MeetSweep(ray, 1, found);
  }
  else if (this->shape_ == Shape::NestedSuperquadric)
  {
    const NestedReference nested(this->exponents_.x, this->exponents_.y, this->exponents_.z);
    const Quad o2[3] = { 2 * ray.origin.x, 2 * ray.origin.y, 2 * ray.origin.z };
    const Quad d2[3] = { 2 * ray.direction.x, 2 * ray.direction.y, 2 * ray.direction.z };
    for (const NestedReference::Crossing& crossing : nested.Crossings(o2, d2, factor == 1.0))
    {
      this->Add(crossing.s, { crossing.gradient[0], crossing.gradient[1], crossing.gradient[2] },
        crossing.edgeDistance / 2, found);
    }
  }
  else if (this->shape_ == Shape::Polynomial)
  {
    const PolynomialReference polynomial(this->polynomial_, this->degree_);
    const Quad o2[3] = { 2 * ray.origin.x, 2 * ray.origin.y, 2 * ray.origin.z };
    const Quad d2[3] = { 2 * ray.direction.x, 2 * ray.direction.y, 2 * ray.direction.z };
    for (const PolynomialReference::Crossing& crossing : polynomial.Crossings(o2, d2))
    {
      this->Add(crossing.s, { crossing.gradient[0], crossing.gradient[1], crossing.gradient[2] },
        crossing.fromCenter / 2, found);
    }
  }
  else
  {
    if (this->shape_ == Shape::Cylinder)
    {
      // The profile's axis is x.
      std::swap(ray.origin.x, ray.origin.y);
      std::swap(ray.direction.x, ray.direction.y);
    }
    for (std::size_t i = 0; i + 1 < this->profile_.size(); ++i)
    {
      const ProfilePoint a = this->profile_[i], b = this->profile_[i + 1];
      if (a.h == b.h)
      {
        this->MeetAnnulus(ray, a, b, found);
      }
      else
      {
        this->MeetFrustum(
          ray, a, b, this->smoothStart_ && i == 0, this->smoothEnd_ && i + 2 == this->profile_.size(), found);
      }
    }
    for (const Ball& ball : this->balls_)
    {
      this->MeetBall(ray, ball, found);
    }
  }

  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  std::vector<ReferenceCrossing> crossings;
  const Quad near = tolerance * this->size_ / sqrtq(Dot(d, d));
  for (ReferenceCrossing& crossing : found)
  {
    crossing.t += start;
    if (crossings.empty() || crossing.t - crossings.back().t > near)
    {
      crossings.push_back(crossing);
    }
    else
    {
      ReferenceCrossing& kept = crossings.back();
      kept.edgeDistance = std::min(kept.edgeDistance, crossing.edgeDistance);
      kept.edgeSizes = std::min(kept.edgeSizes, crossing.edgeSizes);
    }
  }
  return crossings;
}

void ReferenceGlyph::Add(
  Quad t, const QuadVector& unitNormal, Quad edgeDistance, std::vector<ReferenceCrossing>& crossings) const
{
  QuadVector normal = unitNormal;
  if (this->shape_ == Shape::Cylinder)
  {
    std::swap(normal.x, normal.y);
  }
  normal = { normal.x / this->scale_.x, normal.y / this->scale_.y, normal.z / this->scale_.z };
  normal = Turned(this->rotation_, normal, true);
  const Quad length = sqrtq(Dot(normal, normal));
  const Quad least = std::min({ this->scale_.x, this->scale_.y, this->scale_.z }) / this->size_;
  crossings.push_back(
    { t, { normal.x / length, normal.y / length, normal.z / length }, edgeDistance, edgeDistance * least });
}

void ReferenceGlyph::MeetRectangles(const UnitRay& ray, std::vector<ReferenceCrossing>& crossings) const
{
  const Quad o[3] = { ray.origin.x, ray.origin.y, ray.origin.z };
  const Quad d[3] = { ray.direction.x, ray.direction.y, ray.direction.z };
  const Quad half = 0.5;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = -1; side <= 1 && d[axis] != 0; side += 2)
    {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const Quad t = (side * half - o[axis]) / d[axis];
      const Quad inU = half - fabsq(o[u] + t * d[u]);
      const Quad inV = half - fabsq(o[v] + t * d[v]);
      if (inU >= -tolerance && inV >= -tolerance)
      {
        Quad normal[3] = { 0, 0, 0 };
        normal[axis] = side;
        this->Add(t, { normal[0], normal[1], normal[2] }, std::min(inU, inV), crossings);
      }
    }
  }
}

void ReferenceGlyph::MeetSweep(const UnitRay& ray, int side, std::vector<ReferenceCrossing>& crossings) const
{
  const auto toDiagonal = [this](const QuadVector& p)
  {
    const Quad y = p.y / this->half_.y, z = p.z / this->half_.z;
    const Quad x = (p.x - y * this->shear_.x - z * this->shear_.y) / this->shear_.z;
    return Turned(this->diagonal_, { x, y, z }, false);
  };
  const QuadVector o = toDiagonal(ray.origin), d = toDiagonal(ray.direction),
                   way = toDiagonal({ this->halfWay_, 0, 0 });
  const QuadVector& growth = this->exponents_;
  const auto scaled = [](const QuadVector& a, const QuadVector& b) {
    return QuadVector{ a.x * b.x, a.y * b.y, a.z * b.z };
  };
  Quad low = -1, high = 1, s = 0;
  QuadVector gradient;
  bool met = false;
  for (int step = 0; step < 120; ++step)
  {
    // The ends, too
    const Quad height = step == 0 ? low : step == 1 ? high : (low + high) / 2;
    const auto weight = [&](Quad grown) { return 1 / std::max(1 + height * grown, Quad(1e-9f)); };
    const QuadVector weights{ weight(growth.x), weight(growth.y), weight(growth.z) };
    const QuadVector p = At(o, way, -height);
    const Quad a = Dot(scaled(weights, d), d), b = Dot(scaled(weights, p), d);
    const Quad discriminant = b * b - a * (Dot(scaled(weights, p), p) - 1);
    met = discriminant >= 0;
    s = (side * sqrtq(std::max(discriminant, Quad(0))) - b) / a;
    gradient = scaled(weights, At(p, d, s));
    const Quad rate = -2 * Dot(way, gradient) - Dot(scaled(growth, gradient), gradient);
    if (step == 0 ? rate >= 0 : step == 1 && rate <= 0)
    {
      break;
    }
    if (step > 1)
    {
      (rate < 0 ? low : high) = height;
    }
  }
  if (met)
  {
    const QuadVector v = Turned(this->diagonal_, gradient, true);
    const Quad x = v.x / this->shear_.z;
    this->Add(
      s, { x, (v.y - x * this->shear_.x) / this->half_.y, (v.z - x * this->shear_.y) / this->half_.z }, 1, crossings);
  }
}

void ReferenceGlyph::MeetBall(const UnitRay& ray, const Ball& ball, std::vector<ReferenceCrossing>& crossings) const
{
  const QuadVector o{ ray.origin.x - ball.center, ray.origin.y, ray.origin.z };
  const Quad c = Dot(o, o) - ball.radius * ball.radius;
  for (const Quad t : Roots(Dot(ray.direction, ray.direction), Dot(o, ray.direction), c))
  {
    const QuadVector p = At(o, ray.direction, t);
    if (p.x + ball.center >= ball.from - tolerance && p.x + ball.center <= ball.to + tolerance)
    {
      this->Add(t, p, 1, crossings);
    }
  }
}

void ReferenceGlyph::MeetAnnulus(
  const UnitRay& ray, ProfilePoint a, ProfilePoint b, std::vector<ReferenceCrossing>& crossings) const
{
  if (ray.direction.x == 0)
  {
    return;
  }
  const Quad t = (a.h - ray.origin.x) / ray.direction.x;
  const QuadVector p = At(ray.origin, ray.direction, t);
  const Quad r = sqrtq(p.y * p.y + p.z * p.z);
  const Quad inner = std::min(a.r, b.r), outer = std::max(a.r, b.r);
  const Quad inside = std::min(inner > 0 ? r - inner : outer, outer - r);
  if (inside >= -tolerance && outer > inner)
  {
    this->Add(t, { a.r - b.r, 0, 0 }, inside, crossings);
  }
}

void ReferenceGlyph::MeetFrustum(const UnitRay& ray, ProfilePoint a, ProfilePoint b, bool smoothStart, bool smoothEnd,
  std::vector<ReferenceCrossing>& crossings) const
{
  const QuadVector& o = ray.origin;
  const QuadVector& d = ray.direction;
  const Quad slope = (b.r - a.r) / (b.h - a.h);
  const Quad radius = a.r + slope * (o.x - a.h);
  const Quad rate = slope * d.x;
  for (const Quad t : Roots(d.y * d.y + d.z * d.z - rate * rate, o.y * d.y + o.z * d.z - radius * rate,
         o.y * o.y + o.z * o.z - radius * radius))
  {
    const QuadVector p = At(o, d, t);
    const Quad r = a.r + slope * (p.x - a.h);
    const Quad inside = std::min(smoothStart ? Quad(1) : p.x - a.h, smoothEnd ? Quad(1) : b.h - p.x);
    if (p.x >= a.h - tolerance && p.x <= b.h + tolerance && r >= -tolerance && (a.r > 0 || b.r > 0))
    {
      this->Add(t, { -slope * fabsq(r), p.y, p.z }, inside, crossings);
    }
  }
}

} // namespace rtg::testing
