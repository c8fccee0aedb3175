// Contents of a scene as plain host data, without types of Vulkan or VTK.
#pragma once

#include "Motion.h"
#include "Shapes/List.h"
#include "TriangleMesh.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rtg
{

/// A failure that has one clear sentence for the user: the thing, the value found and the remedy.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// There is not enough memory, of the device or of the computer, now.
class OutOfMemory : public Error
{
public:
  using Error::Error;
};

/// The unit glyphs, each in its own frame (Shapes/<Name>.glsl says how large it is and how it stands), and Mesh: the
/// triangles of GlyphInstances::mesh, in their own frame and size.
enum class Shape : std::uint32_t
{
#define RTG_SHAPE_NUMBER(number, Name) Name = number,
  RTG_SHAPES(RTG_SHAPE_NUMBER)
#undef RTG_SHAPE_NUMBER
    Mesh = RTG_MESH
};

/// Several numbers a glyph, as many of each.
struct GlyphTuples
{
  std::vector<float> values;
  std::size_t width = 0; ///< numbers of a glyph

  std::size_t size() const { return this->width == 0 ? 0 : this->values.size() / this->width; }
  bool empty() const { return this->values.empty(); }
  const float* operator[](std::size_t glyph) const { return &this->values[glyph * this->width]; }
  float* operator[](std::size_t glyph) { return &this->values[glyph * this->width]; }
  bool operator==(const GlyphTuples&) const = default;
};

/// All numbers of an array one after the other.
template <class Array>
auto& Flat(Array& array)
{
  if constexpr (std::is_same_v<std::remove_const_t<Array>, GlyphTuples>)
  {
    return array.values;
  }
  else
  {
    return array;
  }
}

///@{
/// Bytes of a glyph in an array, and where they are.
template <class T>
std::size_t RowBytes(const std::vector<T>&)
{
  return sizeof(T);
}
inline std::size_t RowBytes(const GlyphTuples& tuples)
{
  return tuples.width * sizeof(float);
}
template <class Array>
const char* Row(const Array& array, std::size_t glyph)
{
  return reinterpret_cast<const char*>(Flat(array).data()) + glyph * RowBytes(array);
}
///@}

/// Whether a shape has GlyphInstances' exponents.
inline bool HasExponents(Shape shape)
{
  return shape == Shape::Superquadric || shape == Shape::NestedSuperquadric || shape == Shape::SweptEllipsoid;
}

/// Proportions of the unit arrow, as fractions of its length of 1. Defaults are vtkArrowSource's.
struct ArrowForm
{
  float shaftRadius = 0.03f; ///< [0, 0.5]
  float tipRadius = 0.1f;    ///< [0, 0.5]
  float tipLength = 0.35f;   ///< (0, 1]
  /// 0: a sharp cone, vtkArrowSource's outline. 1: fully rounded. In [0, 1].
  float tipRounding = 0.5f;
  /// True: only the shaft grows with an instance's x size; shaft radius and head keep the world size
  /// they have on an arrow of length `unitLength`; an arrow shorter than its head shrinks as a whole.
  /// False: the whole arrow is scaled by the instance's sizes.
  bool fixedHeads = true;
  float unitLength = 1.0f; ///< world length of the arrow whose head has the fractions above; 0: each glyph's size.y

  bool operator==(const ArrowForm&) const = default;
};

/// The glyphs of one set in structure-of-arrays form. An array that a set does not need stays empty
/// and costs nothing: neither memory nor time.
struct GlyphInstances
{
  Shape shape = Shape::Sphere;
  ArrowForm arrow;
  /// Shape::Mesh only: what every glyph is a copy of, scaled by its size, rotated, and moved to its center.
  std::shared_ptr<const TriangleMesh> mesh;
  /// Shape::Mesh only: images name the triangle, not the glyph; for surfaces, which are a single glyph.
  bool identifyTriangles = false;

  /// World position that `centers` are relative to; chosen near the data, subtracted in double.
  glm::dvec3 origin{ 0.0 };
  std::vector<glm::vec3> centers;
  /// Low part of each center, lost by rounding to float, or empty: for sets that extend so far that a float is not
  /// right to 1e-6 of a glyph's size.
  std::vector<glm::vec3> centersLow;

  /// World size of a unit glyph: full extents along its axes. Exactly one of:
  /// sizes3 (one vec3 a glyph), sizes1 (one float a glyph), both empty (uniformSize for all).
  /// Every size is finite and > 0 (of the two diameters of a Shape::RoundCone one may be 0), or < 0 to mirror a
  /// Shape::Mesh; the caller leaves out degenerate glyphs.
  std::vector<glm::vec3> sizes3;
  std::vector<float> sizes1;
  float uniformSize = 1.0f;

  /// Unit quaternions (x, y, z, w) from the unit glyph's frame to the world; empty: none is rotated.
  std::vector<glm::vec4> rotations;

  /// Exponents of the shapes that have them (HasExponents): one vec3 a glyph, or empty
  /// (uniformExponents for all). 2 is round, 1 an octahedron, larger ones approach a box, smaller ones a star.
  /// In [0.1, 100]; see Shapes/README.md for where the accuracy bounds hold.
  std::vector<glm::vec3> exponents3;
  glm::vec3 uniformExponents{ 2.0f };

  /// Coefficients f of a quadratic form in each glyph's own frame, of any scale, or empty. Where there are any, a point
  /// at p from the glyph's center, in its frame, has Material::positiveColor or negativeColor by the sign of f.x
  /// p.x^2 + f.y p.y^2 + f.z p.z^2, in place of the glyphs' colors; their opacity stays. Not for Shape::Mesh.
  std::vector<glm::vec3> forms;

  /// Shape::Polynomial: the values of each glyph's polynomial as FormMeter::Store() makes them, of that even degree,
  /// 2 to 12. In units of a glyph's size its surface is at the distance |f| / 2 from the center.
  /// Shape::SweptEllipsoid: what StoreSweep() makes of the next pieces of a line, or empty: what lies inside these
  /// counts as surface, too.
  GlyphTuples polynomials;
  int polynomialDegree = 0;
  /// Color rule of a point of a glyph's surface, in place of the glyphs' colors; their opacity stays.
  enum class SurfaceColors : std::uint32_t
  {
    None,
    Sign,     ///< of the polynomial, in Material::positiveColor or negativeColor. Shape::Polynomial only
    Direction ///< red, green and blue: |x|, |y|, |z| of the unit vector from the glyph's center. None of Shape::Mesh
  };
  SurfaceColors surfaceColors = SurfaceColors::None;

  /// In [0, 1], times Material::opacity and the alpha of colors; or empty.
  std::vector<float> opacities;

  /// Shape::RoundCone only: what a piece of a line meets at its end at -x and at +x, in its own frame
  /// (Shapes/RoundCone.glsl), or empty: both ends are round, and what lies inside other pieces counts as surface, too.
  /// Shape::SweptEllipsoid: StoreSweep() makes these, sizes and exponents of two ellipsoids.
  std::vector<glm::vec4> before, after;

  GlyphMotion motion;

  std::size_t Count() const { return centers.size(); }
  glm::vec3 SizeOf(std::size_t glyph) const
  {
    return !this->sizes3.empty() ? this->sizes3[glyph]
                                 : glm::vec3(this->sizes1.empty() ? this->uniformSize : this->sizes1[glyph]);
  }
  bool operator==(const GlyphInstances&) const = default; ///< of the same mesh, not of an equal one
};

/// Whether some glyph is not opaque, by arrays other than material and colors.
inline bool IsTranslucent(const GlyphInstances& instances)
{
  return std::any_of(
           instances.opacities.begin(), instances.opacities.end(), [](float opacity) { return opacity < 1.0f; }) ||
    (instances.shape == Shape::Mesh && instances.mesh && IsTranslucent(*instances.mesh));
}

/// Colors of one set, RGBA8 with red in the lowest byte, or none for Material::color.
struct GlyphColors
{
  /// One a glyph in the order of GlyphInstances, or empty. White leaves glyphs with GlyphInstances::forms the two
  /// colors of those, and others those of GlyphInstances::surfaceColors.
  std::vector<std::uint32_t> each;
  /// Shape::RoundCone, Shape::SweptEllipsoid: one at the end at -x and one at that at +x of each glyph, linear between.
  /// Shape::Polynomial: one at its center and one at the distance of half its size from it, linear between. No others.
  /// With a table they are the bits of floats, whose colors the table has as TriangleMesh::valueColors has those of
  /// positions. Where `each` is there, too, only white leaves the color to them, and both opacities count.
  std::vector<glm::uvec2> ends;
  std::vector<std::uint32_t> table;

  GlyphColors() = default;
  GlyphColors(std::vector<std::uint32_t> ofGlyphs)
    : each(std::move(ofGlyphs))
  {
  }
  bool Empty() const { return this->each.empty() && this->ends.empty(); }
  bool operator==(const GlyphColors&) const = default;
};

/// Whether some of them are not opaque.
inline bool AnyTranslucent(const GlyphColors& colors)
{
  const bool plainEnds = colors.table.empty();
  return AnyTranslucent(colors.each) || AnyTranslucent(colors.table) ||
    std::any_of(colors.ends.begin(), colors.ends.end(),
      [plainEnds](const glm::uvec2& ends) { return plainEnds && ((ends.x & ends.y) >> 24) != 255u; });
}

/// A cut through the glyphs of a set: what lies inside a convex body, or all that lies outside it, is not there for any
/// ray. Moving glyphs pass it.
struct Section
{
  enum class Faces : std::uint32_t
  {
    Caps = 0, ///< glyphs and closed meshes that are cut are closed by flat faces in their color; open meshes are not
    Open = 1, ///< without caps
    Whole = 2 ///< glyphs are left out by their centers, none is cut; surfaces (identifyTriangles) are Open
  };
  struct Plane
  {
    glm::dvec3 point{ 0.0 };        ///< in world coordinates
    glm::dvec3 normal{ 0, 0, 1.0 }; ///< out of the body, of any length but zero
    bool operator==(const Plane&) const = default;
  };
  std::vector<Plane> planes; ///< of the body: three, or pairs back to back; none: no cut
  bool keepsInside = false;  ///< of the body, else what is outside it
  Faces faces = Faces::Caps;
  std::optional<glm::vec3> capColor; ///< instead of the glyphs' colors

  bool operator==(const Section&) const = default;
};

/// A set that repeats along the edges of a box, without copies of its arrays. All images have the glyphs' ids.
struct PeriodicImages
{
  std::array<glm::dvec3, 3> edges{}; ///< of the box, world units
  glm::ivec3 shown{ 0 };             ///< images on either side along each edge, >= 0
  glm::ivec3 lit{ 0 };               ///< likewise those that shade others, visible or not; at least as many

  bool Any() const { return this->lit != glm::ivec3(0); }
  bool operator==(const PeriodicImages&) const = default;
};

/// ParaView's surface appearance. Colors are as the lookup table gives them (display-referred).
struct Material
{
  glm::vec3 color{ 1.0f };        ///< diffuse color of glyphs without their own
  glm::vec3 ambientColor{ 1.0f }; ///< ambient color of glyphs without their own
  glm::vec3 specularColor{ 1.0f };
  glm::vec3 positiveColor{ 1.0f }; ///< where GlyphInstances::forms, or polynomials, are zero or more
  glm::vec3 negativeColor{ 1.0f }; ///< where they are less
  float ambient = 0.0f;            ///< [0, 1]
  float diffuse = 1.0f;            ///< [0, 1]
  float specular = 0.0f;           ///< [0, 1]
  float specularPower = 100.0f;    ///< [0, 128] as vtkProperty
  float opacity = 1.0f;            ///< [0, 1]; times a glyph color's alpha
  bool lighting = true;            ///< false: the plain color, as vtkProperty::LightingOff

  // Path tracing only, with vtkProperty's meaning; `specular` is then Burley's (0.5: glass, plastic), `ambient`
  // light that the surface gives off.
  float metallic = 0.0f;      ///< [0, 1]
  float roughness = 0.5f;     ///< [0, 1]
  float coatStrength = 0.0f;  ///< [0, 1]
  float coatRoughness = 0.0f; ///< [0, 1]
  float coatIor = 2.0f;       ///< refractive index, >= 1
  glm::vec3 coatColor{ 1.0f };

  Section section;

  bool operator==(const Material&) const = default;
};

/// A light, in world coordinates, with vtkLight's meaning (vtkOpenGLPolyDataMapper's formulas).
struct Light
{
  enum class Kind : std::uint32_t
  {
    Headlight = 0,   ///< shines along each view direction axis (vtkLight headlight, camera at origin)
    Directional = 1, ///< parallel rays along `direction`
    Positional = 2   ///< from `position`, with attenuation; a spot when coneAngle < 90
  };
  Kind kind = Kind::Headlight;
  glm::vec3 color{ 1.0f };          ///< diffuse color times intensity
  glm::dvec3 position{ 0.0 };       ///< Positional only
  glm::vec3 direction{ 0, 0, -1 };  ///< unit, in which the light travels; Directional and spots
  glm::vec3 attenuation{ 1, 0, 0 }; ///< constant, linear, quadratic
  float coneAngle = 180.0f;         ///< half angle in degrees; 90 or more: no spot
  float exponent = 1.0f;            ///< spot fall-off
  float angularRadius = 0.0f;       ///< of Directional, in degrees, [0, 90]: its shadows have soft edges
  float radius = 0.0f;              ///< of Positional, world units, >= 0: likewise
  bool castsShadow = true; ///< with TraceSettings::shadows; a headlight never does, with path tracing every other does

  bool operator==(const Light&) const = default;
};

} // namespace rtg
