/**
 * How arrays become glyphs: everything that instances depend on besides the data and the actor's matrix. A new field is
 * compared with the others by itself.
 */
#ifndef GlyphSettings_h
#define GlyphSettings_h

#include "DirectionColors.h"
#include "Finite.h"
#include "GlyphForms.h"
#include "GlyphMask.h"
#include "GlyphMotion.h"
#include "GlyphSizing.h"
#include "GlyphTensors.h"
#include "Glyphs.h"
#include "RayTracedArrays.h"
#include "vtkType.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rtglyphs
{

/**
 * What gives glyphs their place, size and rotation, besides the factor and limits of size.
 */
enum class GlyphFrame
{
  Arrays,     // of scales and orientations
  Vector,     // arrows of a vector and its length
  Split,      // the cylinders of the digit and of the power of ten of a vector's length, along it
  Tensor,     // eigenvalues and eigenvectors
  Covariance, // of a Gaussian: the ellipsoid that holds a fraction of it
  Cross,      // arrows along the eigenvectors, to both sides of the center, outward or inward
  Axis,       // an arrow along the axis of the antisymmetric part (GlyphTensors::Axis)
  Tip,        // the ellipsoid of a vector's covariance, round the vector's tip
  Cones       // the cones of its tangents from the vector's tail (GlyphTensors::ConeOf)
};

/**
 * What a GlyphShape consists of: first the glyphs themselves, then what surrounds them.
 */
struct GlyphLayer
{
  rtg::Shape Shape;
  GlyphFrame Frame;
  double Opacity = 1.0; // of the display's

  /// GLYPH_TYPE's shape is that of its source.
  static std::vector<GlyphLayer> Of(int glyphShape);
  static constexpr double around = 0.4; // opacity of what glyphs are seen through
};

/**
 * Settings of the magnitudes of glyphs (GlyphMagnitudes). An enumeration's type has its range.
 */
struct GlyphScaling
{
  enum ScaleModes
  {
    MAGNITUDE = 0,
    COMPONENTS = 1
  };

  rtg::Shape Shape = rtg::Shape::Sphere;
  GlyphFrame Frame = GlyphFrame::Arrays;
  bool Scaling = false;
  std::string ScaleArray; // empty or "None": none
  RayTracedEnum<ScaleModes, MAGNITUDE, COMPONENTS> ScaleMode;
  GlyphSizing Sizing;             // of magnitudes of the scale array, and of eigenvalues
  GlyphTensors::Settings Tensors; // on: they give size, rotation and exponents
  GlyphForms::Settings Forms;     // on: polynomials are the glyphs' shape and size
  GlyphMask Mask;

  bool operator==(const GlyphScaling&) const = default;

  ///@{
  /// Whether the scale array is that of the directions, of 2 or 3 components, without which there are no glyphs; and
  /// whether glyphs go with others of these, whose messages name what is wrong with the vectors.
  bool IsOfVectors() const { return this->Frame == GlyphFrame::Vector || this->Frame == GlyphFrame::Split; }
  bool IsAroundVectors() const { return this->Frame == GlyphFrame::Tip || this->Frame == GlyphFrame::Cones; }
  ///@}

  /// Glyphs of a point.
  int Parts() const
  {
    return this->Frame == GlyphFrame::Cross                                  ? 6
      : this->Frame == GlyphFrame::Split || this->Frame == GlyphFrame::Cones ? 2
                                                                             : 1;
  }

  /// Scale of a glyph by its magnitude.
  double Scale(double magnitude) const
  {
    return this->Frame == GlyphFrame::Split ? SplitNumber(magnitude).Length() : this->Sizing(magnitude);
  }
};

struct GlyphSettings : GlyphScaling
{
  enum OrientationModes
  {
    DIRECTION = 0,
    ROTATION = 1,
    QUATERNION = 2,
    MATRIX = 3 // of rotation, row by row; tuples of nine components
  };
  enum Anchors
  {
    ORIGIN = 0, // of the unit glyph: an arrow's tail, the middle of all other shapes but meshes
    TAIL = 1,   // where the glyph begins along its own x axis
    CENTER = 2, // half-way between
    TIP = 3     // where it ends
  };

  GlyphSettings() = default;
  GlyphSettings(const GlyphScaling& scaling)
    : GlyphScaling(scaling)
  {
  }

  double ScaleFactor = 1.0;   // world units
  glm::dvec3 UnitSize{ 1.0 }; // of the shape as its source makes it, in unit glyphs
  std::string RadiusArray;    // across the glyph's x axis, instead of the scale; empty or "None": none
  bool Orient = true;
  std::string OrientationArray; // empty or "None": none
  RayTracedEnum<OrientationModes, DIRECTION, QUATERNION> OrientationMode;
  RayTracedEnum<Anchors, ORIGIN, TIP> Anchor; // what of the glyph lies at its point; not of tensors' glyphs
  rtg::ArrowForm Arrow;                       // its unit length is computed
  double ArrowReference =
    0.0; // magnitude of the arrow whose head has the unit arrow's proportions; 0: ScalePercentile's
  double ScalePercentile = 0.0;                  // 95th percentile of the scales of all ranks' glyphs
  std::shared_ptr<const rtg::TriangleMesh> Mesh; // for rtg::Shape::Mesh
  int TableSize = 1;                             // of a table of meshes, of which Mesh is
  int TableEntry = 0;                            // that number: only points that choose it show it
  std::string TableIndexArray;                   // empty or "None": all points choose entry 0
  double Exponents[3] = { 2.0, 2.0, 2.0 };       // of superquadrics; each counts as one in [0.1, 100]
  std::string ExponentArray;                     // overrides them; empty or "None": none
  std::string OpacityArray;                      // empty or "None": none
  // What directions color, whatever else would; of tensors and polynomials, whose axes have no sign, at most AXES.
  RayTracedEnum<DirectionColors::Kinds, DirectionColors::NONE, DirectionColors::SPHERE> DirectionColoring;
  GlyphMotion::Settings Motion; // on: the glyphs move while the shutter is open
  int TrailSteps = 0; // > 0: of the glyphs, the trails over so many earlier steps (GlyphTrails), or bounds with these
  bool TrailJoined = false; // inside them there is no surface, as translucent ones show
  bool Shell = false;       // around glyphs of other sizes, whose messages say what both lack
  ///@{
  // Instances do not depend on these: the opacity, of the display's, and how much of it trails lose to their last step.
  double Opacity = 1.0;
  double TrailFading = 0.0;
  ///@}

  bool operator==(const GlyphSettings&) const = default;

  /**
   * The same with numbers out of range replaced by the nearest in it, NaN by the default.
   */
  GlyphSettings InRange() const;

  /**
   * These settings with all that has no effect on instances set to its default. Two that are equal then make the same
   * instances of the same arrays; colors are none of them.
   */
  GlyphSettings Effective() const;

  /**
   * Those that magnitudes and the choice of points depend on, all others at their defaults.
   */
  GlyphScaling OfMagnitudes() const;

  /**
   * Whether fixed arrow heads have the proportions of the unit arrow on the 95th percentile's arrow.
   */
  bool NeedsScalePercentile() const
  {
    return this->Shape == rtg::Shape::Arrow && this->Arrow.fixedHeads && this->Scaling &&
      !RayTracedArrays::IsNone(this->ScaleArray) && !rtg::IsPositive(this->ArrowReference);
  }

  /**
   * The scale of the arrow whose fixed head has the proportions of the unit arrow.
   */
  double ReferenceScale() const;

  /**
   * Whether the points choose among several meshes.
   */
  bool HasTable() const { return this->Shape == rtg::Shape::Mesh && this->TableSize > 1; }

  /**
   * Whether the shape is a superquadric with exponents of these settings; those of tensors come from elsewhere.
   */
  bool HasOwnExponents() const { return HasExponents(this->Shape) && !this->Tensors.On; }

  /**
   * Color rule for points of each glyph's surface: none, the sign of the tensor or polynomial in their direction,
   * or that direction.
   */
  rtg::GlyphInstances::SurfaceColors SurfaceColors() const;

  /**
   * Whether one number of each glyph, or of each point of its surface, colors it: one of GlyphTensorRange.
   */
  bool HasNumberRange() const { return this->Tensors.HasRange() || this->Forms.ColorsByRadius(); }

  /**
   * The magnitude, as GlyphMagnitudes has it, of the glyph that shows this number: of a covariance a variance.
   */
  double MagnitudeOf(double number) const
  {
    return this->Tensors.Covariances ? 2.0 * GlyphTensors::RadiusOf(this->Tensors.Confidence) * std::sqrt(number)
                                     : this->Scale(number);
  }

  /**
   * World size along the longest axis of a glyph of this magnitude, as GlyphMagnitudes has it.
   */
  double Length(double magnitude) const { return this->Sizing.Limited(std::abs(this->ScaleFactor) * magnitude); }

  /**
   * The size across its x axis of a glyph with this value of the radius array. The radius of an arrow is that of its
   * shaft, or of its head where it has no shaft.
   */
  double Width(double radius) const;

  /**
   * How far Anchor moves the unit glyph along its own x axis.
   */
  double AnchorShift() const;

  /**
   * The same data in a layer, with all that does not apply there at its default. Only glyphs of Arrays, and ellipsoids,
   * turn while the shutter is open. Axes are as long as the factors and scales that make a tensor glyph's axis out of
   * an eigenvalue make of the vector's length; components of a scale array belong to the glyph's own axes and do not
   * count.
   */
  GlyphSettings In(const GlyphLayer& layer) const;

  /**
   * The trails of the glyphs. They stand still, and have the glyphs' colors, where these are not of each place on the
   * surface.
   */
  GlyphSettings Trails(int steps, double fading) const;

  /**
   * One of the two cylinders that show a vector's magnitude, in unit glyphs along the vector from its point: the digit
   * (0), thin, before the power (1), thick, which lies behind the point where it is negative.
   */
  struct Cylinder
  {
    double Begin, End, Radius;
    double Length() const { return this->End - this->Begin; }
  };
  Cylinder CylinderOf(double magnitude, int part) const;

  /**
   * Shells around the glyphs, of another array of tensors, or of sizes.
   */
  GlyphSettings Shells(const std::string& array) const;
};

} // namespace rtglyphs

#endif
