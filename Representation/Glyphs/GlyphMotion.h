/**
 * @class   GlyphMotion
 * @brief   arrays of velocities, accelerations and angular velocities as the motion of glyphs
 *
 * A glyph is at x + v t + a t^2 / 2 and turned by its angular velocity times t while the shutter is open; see
 * Kernels/Motion.h.
 */
#ifndef GlyphMotion_h
#define GlyphMotion_h

#include "Motion.h"
#include "RayTracedRanges.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace rtglyphs
{

class GlyphMotion
{
public:
  enum Openings
  {
    CENTERED = 0, // from half the shutter time before the data's time to half of it after
    FORWARD = 1,  // from the data's time on
    BACKWARD = 2  // until the data's time
  };

  struct Settings
  {
    bool On = false;
    // Names of point arrays of two components, in a plane, or three; empty or "None": none
    std::string Velocity; // also RayTracedArrays::StepVelocity
    std::string Acceleration;
    std::string AngularVelocity; // radians per time
    std::string Mask;            // of one component: points where it is 0 or NaN stand still; empty or "None": none do
    double ShutterTime = 0.0;    // in the arrays' unit of time; 0: by the data (RayTracedTime)
    int Opening = CENTERED;

    bool operator==(const Settings&) const = default;

    /// With all that has no effect at its default.
    Settings Effective() const { return this->On ? *this : Settings(); }
  };

  /**
   * The named arrays of velocities, accelerations, angular velocities and the mask when the settings are on; null where
   * none is named, or it is missing.
   */
  static std::array<vtkDataArray*, 4> Arrays(vtkPolyData* points, const Settings& settings);

  /**
   * Takes the valid arrays of `points`; Messages() reports others. Points of
   * blocks that lack an array stand still.
   */
  GlyphMotion(vtkPolyData* points, const Settings& settings);

  /**
   * Reports which blocks lack one of the arrays (RayTracedBlocks::ReportMissing).
   */
  static void ReportMissing(
    vtkPolyData* points, const Settings& settings, const RayTracedRanges& hidden, std::vector<std::string>& messages);

  const std::vector<std::string>& Messages() const { return this->Messages_; }

  /**
   * Missing input of motion; empty: none.
   */
  static std::string MissingInput(const Settings& settings);

  bool On() const { return this->Found[0] || this->Found[1] || this->Found[2]; }
  bool Spins() const { return this->Found[2] != nullptr; }

  /**
   * False: one of the point's tuples is not finite.
   */
  bool IsFinite(vtkIdType point) const;

  ///@{
  /**
   * Allocate() makes room for so many glyphs; then Store() makes the point's motion that of a glyph. Threads may store
   * at the same time.
   */
  void Allocate(rtg::GlyphMotion& motion, std::size_t count) const;
  void Store(rtg::GlyphMotion& motion, std::size_t glyph, vtkIdType point, const glm::dmat3& linear,
    const glm::dmat3& rotation) const;
  ///@}

  /**
   * Sets the shutter, and empties arrays that are zero all over: glyphs at rest then cost what glyphs without motion
   * cost.
   */
  void Finish(rtg::GlyphMotion& motion) const;

  /**
   * Bounds of the displacements of a point whose tuples are finite.
   */
  rtg::DoubleBox Range(vtkIdType point) const;

private:
  glm::dvec3 Tuple(int kind, vtkIdType point) const; // zero of points that the mask leaves out

  std::array<vtkDataArray*, 4> Found{};
  std::vector<std::string> Messages_;
  double Open = 0.0, Close = 0.0;
};

} // namespace rtglyphs

#endif
