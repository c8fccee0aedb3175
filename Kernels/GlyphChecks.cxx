#include "GlyphChecks.h"

#include "Finite.h"
#include "GlyphArrays.h"
#include "HarmonicForms.h"
#include "Parallel.h"
#include "SweptEllipsoid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>
#include <vector>

namespace rtg
{

namespace
{

template <int n>
std::ostream& operator<<(std::ostream& out, const glm::vec<n, float>& value)
{
  for (int i = 0; i < n; ++i)
  {
    out << (i == 0 ? "(" : ", ") << value[i];
  }
  return out << ")";
}

template <class... Parts>
[[noreturn]] void Fail(const Parts&... parts)
{
  std::ostringstream message;
  message << "Ray Traced Glyphs: ";
  (message << ... << parts);
  throw Error(message.str());
}

// Names the first value that is not good.
template <class T, class Good>
void CheckEach(const char* words, const std::vector<T>& values, const Good& good)
{
  std::atomic<std::size_t> first(values.size());
  ParallelChunks(values.size(),
    [&](std::size_t begin, std::size_t end)
    {
      const auto bad = std::find_if_not(values.begin() + begin, values.begin() + end, good);
      const auto at = static_cast<std::size_t>(bad - values.begin());
      std::size_t known = first;
      while (at < end && at < known && !first.compare_exchange_weak(known, at))
      {
      }
    });
  if (first < values.size())
  {
    Fail("one of the ", words, " is ", values[first], "; leave that glyph out.");
  }
}

template <class T>
void CheckFinite(const char* words, const std::vector<T>& values)
{
  CheckEach(words, values, [](const T& value) { return IsFinite(value); });
}

// Throws unless every array has an entry a glyph or none.
void CheckLengths(const GlyphInstances& instances, const GlyphColors& colors)
{
  ForEachArray(instances, colors,
    [&](std::size_t, std::uint32_t, const auto& values, const char* words)
    {
      if (!values.empty() && values.size() != instances.Count())
      {
        Fail(values.size(), " ", words, " for ", instances.Count(), " glyphs; give one a glyph or none.");
      }
    });
}

// The lengths of its arrays are known to be right.
void CheckMotion(const GlyphMotion& motion)
{
  CheckFinite("velocities", motion.velocities);
  CheckFinite("accelerations", motion.accelerations);
  CheckFinite("angular velocities", motion.angularVelocities);
}

void CheckShutter(const GlyphMotion& motion)
{
  if (!IsPositive(motion.shutterClose - motion.shutterOpen))
  {
    Fail("the shutter opens at ", motion.shutterOpen, " and closes at ", motion.shutterClose,
      "; it must close later than it opens.");
  }
}

void CheckPolynomials(const GlyphInstances& instances)
{
  const int degree = instances.polynomialDegree;
  const bool even = degree >= 2 && degree <= mostDegree && degree % 2 == 0;
  if (!even || instances.polynomials.empty() ||
    instances.polynomials.width != static_cast<std::size_t>(3 + FormTerms(degree)))
  {
    Fail("polynomials of degree ", degree, " with ", instances.polynomials.width,
      " values a glyph; give an even degree from 2 to 12 and the values of FormMeter.");
  }
}

void CheckSizes(const GlyphInstances& instances)
{
  const Shape shape = instances.shape;
  const auto good = [shape](float size)
  {
    // A negative one mirrors; one of two diameters may be zero.
    return std::isfinite(size) &&
      (shape == Shape::Mesh           ? size != 0.0f
          : shape == Shape::RoundCone ? size >= 0.0f
                                      : size > 0.0f);
  };
  if (instances.sizes1.empty() && instances.sizes3.empty() && !good(instances.uniformSize))
  {
    Fail("the size of glyphs is ", instances.uniformSize, "; it must be finite and above zero.");
  }
  CheckEach("sizes", instances.sizes1, good);
  CheckEach("sizes along three axes", instances.sizes3,
    [&](const glm::vec3& size) { return good(size.x) && good(size.y) && good(size.z); });
}

void CheckExponents(const GlyphInstances& instances)
{
  const auto good = [](const glm::vec3& e) { return IsFinite(e) && e.x > 0.0f && e.y > 0.0f && e.z > 0.0f; };
  if (instances.exponents3.empty() && !good(instances.uniformExponents))
  {
    Fail("the exponents of glyphs are ", instances.uniformExponents, "; they must be finite and above zero.");
  }
  CheckEach("exponents", instances.exponents3, good);
}

} // namespace

void CheckInstances(const GlyphInstances& instances, std::size_t most)
{
  CheckLengths(instances, {});
  if (instances.Count() > most)
  {
    Fail("a set of ", instances.Count(), " glyphs; the most that one can hold is ", most,
      ". Show fewer glyphs (GlyphMode, MaximumNumberOfGlyphs).");
  }
  if (!instances.sizes3.empty() && !instances.sizes1.empty())
  {
    Fail("glyphs have sizes along three axes and single ones; give one kind of them.");
  }
  if (instances.surfaceColors == GlyphInstances::SurfaceColors::Sign && instances.shape != Shape::Polynomial)
  {
    Fail("glyphs are to be colored by the sign of a polynomial, which their shape does not have; choose other colors.");
  }
  CheckMotion(instances.motion);
  if (instances.motion.Any())
  {
    CheckShutter(instances.motion);
  }
  if (instances.Count() == 0)
  {
    return;
  }
  if (instances.polynomials.values.size() > most)
  {
    Fail(instances.Count(), " glyphs of ", instances.polynomials.width,
      " values each have more values than a set can hold, which is ", most, "; show fewer of them.");
  }
  if (instances.shape == Shape::Polynomial)
  {
    CheckPolynomials(instances);
  }
  if (instances.shape == Shape::SweptEllipsoid &&
    (instances.sizes3.empty() || instances.rotations.empty() || instances.exponents3.empty() ||
      instances.before.empty() || instances.after.empty() ||
      (!instances.polynomials.empty() && instances.polynomials.width != valuesOfNextSweeps)))
  {
    Fail("swept ellipsoids lack some of their arrays; fill them with StoreSweep().");
  }
  CheckSizes(instances);
  if (HasExponents(instances.shape))
  {
    CheckExponents(instances);
  }
  CheckFinite("centers", instances.centers);
  CheckFinite("low parts of centers", instances.centersLow);
  CheckFinite("rotations", instances.rotations);
}

void CheckColors(const GlyphInstances& instances, const GlyphColors& colors)
{
  CheckLengths(instances, colors);
  if (!colors.table.empty() && colors.table.size() < 3)
  {
    Fail("the values at the ends of glyphs have a table of ", colors.table.size(),
      " colors; it must have 3 or more, the last two of which are those of NaN and of a missing "
      "value.");
  }
}

void CheckMesh(const TriangleMesh* mesh, const GlyphMotion& shutter, std::size_t most)
{
  if (!mesh || mesh->triangles.empty())
  {
    Fail("the mesh has no triangle; choose a source with polygons.");
  }
  const auto fits = [&](const char* name, std::size_t found, std::size_t wanted)
  {
    if (found != 0 && found != wanted)
    {
      Fail("the mesh has ", found, " ", name, "; it must have ", wanted, " or none.");
    }
  };
  fits("normals", mesh->normals.size(), mesh->positions.size());
  fits("colors of positions", mesh->positionColors.size(), mesh->positions.size());
  fits("colors of triangles", mesh->triangleColors.size(), mesh->triangles.size());
  fits("values of positions", mesh->positionValues.size(), mesh->positions.size());
  fits("velocities", mesh->motion.velocities.size(), mesh->positions.size());
  fits("accelerations", mesh->motion.accelerations.size(), mesh->positions.size());
  const auto holds = [](const char* name, std::size_t found, std::size_t mostOfThese)
  {
    if (found > mostOfThese)
    {
      Fail("a mesh of ", found, " ", name, "; the most that one can have is ", mostOfThese,
        ". Show a part of it, or decimate it.");
    }
  };
  // Three corners each; and the table of colors lies behind the values.
  holds("triangles", mesh->triangles.size(), most / 3);
  holds("positions", mesh->positions.size(), most - std::min(most, mesh->valueColors.size()));
  if (!mesh->positionValues.empty() && mesh->valueColors.size() < 3)
  {
    Fail("the mesh has values of positions, but no table of colors for them.");
  }
  for (const glm::uvec3& corner : mesh->triangles)
  {
    const std::uint32_t largest = std::max({ corner.x, corner.y, corner.z });
    if (largest >= mesh->positions.size())
    {
      Fail("a triangle of the mesh has corner ", largest, " of ", mesh->positions.size(), " positions.");
    }
  }
  CheckFinite("positions of the mesh", mesh->positions);
  CheckMotion(mesh->motion);
  if (mesh->motion.Spins())
  {
    Fail("the positions of a mesh have angular velocities; they can have velocities and accelerations.");
  }
  if (mesh->motion.Moves())
  {
    CheckShutter(shutter);
  }
}

std::vector<device::SectionSlab> SlabsOf(const Section& section, const glm::dvec3& origin)
{
  std::vector<device::SectionSlab> slabs;
  for (const Section::Plane& plane : section.planes)
  {
    // The plane passes its point, however its normal is rounded.
    const glm::vec3 normal(glm::normalize(plane.normal));
    const double offset = glm::dot(glm::dvec3(normal), plane.point - origin);
    const float high = static_cast<float>(offset);
    const glm::vec2 words(high, static_cast<float>(offset - high));
    const auto faced = std::find_if(slabs.begin(), slabs.end(),
      [&](const device::SectionSlab& slab)
      { return slab.lower.x == device::SECTION_UNBOUNDED && slab.normal == -normal; });
    if (faced != slabs.end())
    {
      faced->lower = -words;
    }
    else
    {
      slabs.push_back({ normal, { device::SECTION_UNBOUNDED, 0.0f }, words });
    }
  }
  return slabs;
}

void CheckSection(const Section& section)
{
  for (const Section::Plane& plane : section.planes)
  {
    const double length = glm::length(plane.normal);
    const double farthest = glm::length(plane.point);
    if (!(length > 0.0 && std::isfinite(length) && std::isfinite(farthest)))
    {
      Fail("a plane of a cut has a normal of length ", length, " and a point ", farthest,
        " from the origin; give it a normal of some length and a finite point.");
    }
  }
  if (const std::size_t slabs = SlabsOf(section, {}).size(); slabs > 3)
  {
    Fail("a cut has ", section.planes.size(), " planes, which bound ", slabs, " slabs; it can have three.");
  }
}

void CheckImages(const PeriodicImages& images)
{
  constexpr int most = 11 * 11 * 11;
  std::size_t count = 1;
  for (int i = 0; i < 3; ++i)
  {
    const double length = glm::length(images.edges[i]);
    if (images.shown[i] < 0 || images.lit[i] < images.shown[i] || (images.lit[i] > 0 && !std::isfinite(length)))
    {
      Fail("periodic images: ", images.shown[i], " shown and ", images.lit[i], " lit along an edge of length ", length,
        "; give a finite edge, and at least as many that are lit as are shown.");
    }
    count *= 2 * static_cast<std::size_t>(std::min(images.lit[i], most)) + 1;
  }
  if (count > most)
  {
    Fail(count, " periodic images exceed the limit; a set can have ", most, " with those that only shade others.");
  }
}

} // namespace rtg
