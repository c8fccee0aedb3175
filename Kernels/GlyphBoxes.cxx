#include "GlyphBoxes.h"

#include "MeshTree.h"
#include "Parallel.h"
#include "Shapes/Shapes.h"
#include "TimeSlices.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <limits>

namespace rtg
{

namespace
{

// Shapes are bounded in single precision, and every box is widened by what that loses, a few roundings of the glyph's
// own size. Only what lies between glyphs, their centers and paths, needs double.
using HostShapes = shapes::Kernel<float>;
constexpr float roundings = 1e-6f;

// The glyph's size is known already.
template <class Real>
void SetArrow(typename shapes::Kernel<Real>::Glyph& glyph, const ArrowForm& arrow)
{
  glyph.arrow = glm::vec4(arrow.shaftRadius, arrow.tipRadius, arrow.tipLength, arrow.tipRounding);
  glyph.fixedHeads = arrow.fixedHeads;
  glyph.unitLength = arrow.unitLength > 0.0f ? Real(arrow.unitLength) : glyph.size.y;
}

// The glyph with its center at 0.
HostShapes::Glyph GlyphAtZero(const GlyphInstances& instances, std::size_t i)
{
  HostShapes::Glyph glyph;
  glyph.center = glyph.centerLow = glm::vec3(0.0f);
  glyph.size = instances.SizeOf(i);
  glyph.sameSize = instances.sizes3.empty();
  glyph.joined = false;
  glyph.rotated = !instances.rotations.empty();
  glyph.rotation = glyph.rotated ? instances.rotations[i] : glm::vec4(0, 0, 0, 1);
  SetArrow<float>(glyph, instances.arrow);
  glyph.exponents = instances.exponents3.empty() ? instances.uniformExponents : instances.exponents3[i];
  // A flat end cuts a little off the box of the round one.
  const bool swept = instances.shape == Shape::SweptEllipsoid;
  glyph.before = swept ? instances.before[i] : glm::vec4(0.0f);
  glyph.after = swept ? instances.after[i] : glm::vec4(0.0f);
  glyph.values = instances.polynomials.empty() ? nullptr : instances.polynomials[i];
  glyph.firstValue = 0;
  glyph.degree = instances.polynomialDegree;
  return glyph;
}

glm::dvec3 Center(const GlyphInstances& instances, std::size_t i)
{
  const glm::dvec3 center(instances.centers[i]);
  return instances.centersLow.empty() ? center : center + glm::dvec3(instances.centersLow[i]);
}

// A float that is not above the value, at most two ulps below. Without glm::abs, which branches on the sign.
float RoundDown(double value)
{
  constexpr double ulp = std::numeric_limits<float>::epsilon(), least = std::numeric_limits<float>::denorm_min();
  return static_cast<float>(value - (ulp * std::abs(value) + least));
}

glm::vec3 RoundDown(const glm::dvec3& values)
{
  return { RoundDown(values.x), RoundDown(values.y), RoundDown(values.z) };
}

glm::vec3 RoundUp(const glm::dvec3& values)
{
  return -RoundDown(-values);
}

// Subjects of the boxes: glyphs, and for meshes the mesh.
struct Subject
{
  Subject(const GlyphInstances& glyphs, double firstTime, double lastTime)
    : instances(glyphs)
    , form(glyphs.shape == Shape::Mesh ? BoundsOf(*glyphs.mesh, firstTime, lastTime) : DoubleBox())
  {
  }

  const GlyphInstances& instances;
  DoubleBox form; ///< of the mesh
};

// The boxes of single glyphs are relative to their centers.
DoubleBox MeshBox(const DoubleBox& form, const HostShapes::Glyph& glyph, const glm::dvec3& center)
{
  const glm::dvec3 middle = 0.5 * (form.lower + form.upper);
  const glm::dvec3 reach = 0.5 * (form.upper - form.lower);
  glm::dmat3 linear(1.0);
  if (glyph.rotated)
  {
    const glm::dvec4 q(glyph.rotation);
    linear = glm::mat3_cast(glm::normalize(glm::dquat(q.w, q.x, q.y, q.z)));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    linear[axis] *= glyph.size[axis];
  }
  const glm::dvec3 offset = linear * middle;
  // A few ulps for the roundings of the device's own transform.
  const glm::dvec3 half =
    1.000001 * (glm::abs(linear[0]) * reach.x + glm::abs(linear[1]) * reach.y + glm::abs(linear[2]) * reach.z) +
    1e-6 * (glm::abs(center + offset) + glm::length(offset));
  return { offset - half, offset + half };
}

DoubleBox StillBox(const Subject& subject, const HostShapes::Glyph& glyph, const glm::dvec3& center)
{
  if (subject.instances.shape == Shape::Mesh)
  {
    return MeshBox(subject.form, glyph, center);
  }
  glm::vec3 lower, upper;
  HostShapes::GlyphBounds(subject.instances.shape, glyph, lower, upper);
  // Each axis of the box depends on all axes of a rotated glyph.
  const glm::vec3 reach = glm::max(glm::abs(lower), glm::abs(upper));
  const glm::vec3 padding = roundings * (glyph.rotated ? glm::vec3(std::max({ reach.x, reach.y, reach.z })) : reach);
  return { glm::dvec3(lower - padding), glm::dvec3(upper + padding) };
}

// For a glyph that rotates between two times: the boxes at the middles of so short pieces that in half of one no
// point goes further than a fortieth of its distance from the center (longer ones of fast rotations), widened by the
// distance it goes.
DoubleBox SpunBox(const Subject& subject, std::size_t i, double first, double last)
{
  const GlyphInstances& instances = subject.instances;
  const HostShapes::Glyph still = GlyphAtZero(instances, i);
  const glm::dvec3 center = Center(instances, i);
  const glm::dquat rotation(still.rotation.w, still.rotation.x, still.rotation.y, still.rotation.z);
  HostShapes::Glyph upright = still;
  upright.rotated = false;
  const DoubleBox own = StillBox(subject, upright, center);
  const double radius = glm::length(glm::max(glm::abs(own.lower), glm::abs(own.upper)));
  const DoubleBox ball{ glm::dvec3(-radius), glm::dvec3(radius) };

  const double angle = glm::length(glm::dvec3(instances.motion.angularVelocities[i])) * (last - first);
  constexpr double mostPieces = 64.0;
  const double pieces = std::clamp(std::ceil(angle / 0.05), 1.0, mostPieces);
  DoubleBox box;
  for (double piece = 0.5; piece < pieces; piece += 1.0)
  {
    HostShapes::Glyph rotated = still;
    rotated.rotated = true;
    const glm::dquat orientation = instances.motion.RotationAt(i, first + (last - first) * piece / pieces) * rotation;
    rotated.rotation = glm::vec4(orientation.x, orientation.y, orientation.z, orientation.w);
    box.Include(StillBox(subject, rotated, center));
  }
  const double deviation = radius * (0.5 * angle / pieces);
  return { glm::max(box.lower - deviation, ball.lower), glm::min(box.upper + deviation, ball.upper) };
}

DoubleBox StillBox(const Subject& subject, std::size_t i)
{
  return StillBox(subject, GlyphAtZero(subject.instances, i), Center(subject.instances, i));
}

DoubleBox MovingBox(const Subject& subject, std::size_t i, double first, double last)
{
  const GlyphMotion& motion = subject.instances.motion;
  DoubleBox box = motion.Spins() ? SpunBox(subject, i, first, last) : StillBox(subject, i);
  if (motion.Spins())
  {
    // The device's rotations are right to 2^-20 of the glyph's extent (Programs/motion.glsl).
    box = box.Widened(std::ldexp(glm::length(box.upper - box.lower), -18));
  }
  if (motion.Moves())
  {
    const DoubleBox range = PaddedRangeOfDisplacements(motion, i, first, last);
    box.lower += range.lower;
    box.upper += range.upper;
  }
  return box;
}

} // namespace

std::vector<Box> GlyphBoxes(const GlyphInstances& instances, double first, double last)
{
  const bool moves = instances.motion.Any();
  const double opening = instances.motion.EarliestTime(first);
  const double closing = instances.motion.LatestTime(last);
  const Subject subject(instances, opening, closing);
  std::vector<Box> boxes(instances.Count());
  ParallelEach(boxes.size(),
    [&](std::size_t i)
    {
      const DoubleBox box = moves ? MovingBox(subject, i, opening, closing) : StillBox(subject, i);
      const glm::dvec3 center = Center(instances, i);
      boxes[i] = { RoundDown(center + box.lower), RoundUp(center + box.upper) };
    });
  return boxes;
}

bool AreBalls(const GlyphInstances& instances)
{
  return instances.shape == Shape::Sphere && instances.sizes3.empty() && instances.rotations.empty() &&
    !instances.motion.Any();
}

std::vector<Box> ListedBoxes(const GlyphInstances& instances)
{
  return AreBalls(instances) ? std::vector<Box>() : GlyphBoxes(instances);
}

// Widened as the box of any other glyph.
Box BallBox(const glm::vec3& center, const glm::vec3& centerLow, float size)
{
  const float reach = 0.5f * size;
  const double half = reach + roundings * std::abs(reach);
  const glm::dvec3 middle = glm::dvec3(center) + glm::dvec3(centerLow);
  return { RoundDown(middle - half), RoundUp(middle + half) };
}

Box UnionOf(const BoxReader& boxes)
{
  std::vector<Box> parts((boxes.Count() + parallelChunk - 1) / parallelChunk);
  ParallelChunks(boxes.Count(),
    [&](std::size_t first, std::size_t last)
    {
      Box& part = parts[first / parallelChunk];
      for (std::size_t i = first; i < last; ++i)
      {
        part.Include(boxes[i]);
      }
    });
  Box all;
  for (const Box& part : parts)
  {
    all.Include(part);
  }
  return all;
}

std::vector<Box> InOrder(const BoxReader& boxes, const std::vector<std::uint32_t>& order)
{
  const BoxReader ordered(boxes, order);
  std::vector<Box> sorted(boxes.Count());
  ParallelEach(sorted.size(), [&](std::size_t i) { sorted[i] = ordered[i]; });
  return sorted;
}

DoubleBox GlyphExtent(Shape shape, const ArrowForm& arrow, const glm::dvec3& size)
{
  shapes::Kernel<double>::Glyph glyph{};
  glyph.size = size;
  constexpr float unitForm[] = { 1.0f, 1.0f, 1.0f }; // the largest polynomial's
  glyph.values = unitForm;
  SetArrow<double>(glyph, arrow);
  DoubleBox box;
  shapes::Kernel<double>::GlyphBounds(shape, glyph, box.lower, box.upper);
  return box;
}

std::uint32_t TimeSliceBits(const GlyphInstances& instances, std::size_t bytesPerSlice)
{
  const GlyphMotion& motion = instances.motion;
  const Subject subject(instances, motion.Time(0.0), motion.Time(1.0));
  return ChooseSliceBits(
    instances.Count(), bytesPerSlice, [&](std::size_t i, double) { return StillBox(subject, i); },
    [&](std::size_t i, double first, double last)
    { return MovingBox(subject, i, motion.Time(first), motion.Time(last)); });
}

} // namespace rtg
