/**
 * @class   TubePieces
 * @brief   builds the round cones that the kernels trace from lines of balls
 *
 * Each piece between two balls of a line that do not coincide is a round cone (Kernels/Shapes/RoundCone.glsl). A line
 * whose first place is also its last one has no ends. Balls nearer to a flat end than their radius are left out, so
 * that the line is straight there: they would stick out.
 */
#ifndef TubePieces_h
#define TubePieces_h

#include "GlyphPlacement.h"
#include "Glyphs.h"
#include "vtkType.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace rtglyphs
{

class TubePieces
{
public:
  struct Ball
  {
    glm::dvec3 Place; // in the world; of pieces relative to the middle of all
    double Radius;    // not finite or negative: the line is interrupted
    vtkIdType Point;
  };
  using Balls = std::vector<Ball>;

  struct Piece
  {
    vtkIdType Line;
    const Ball *First, *Last, *Before, *After; // the latter two null at ends of the line
  };

  virtual ~TubePieces() = default;

protected:
  /**
   * `modelToWorld` may be null.
   */
  TubePieces(vtkMatrix4x4* modelToWorld, bool flatEnds, bool joined);

  /// Of radii.
  double Factor() const;

  ///@{
  /**
   * Makes Instances. Threads call ForLines(), which calls use(line, balls) for each line that has balls, more than
   * once for the same lines, and Place(), after one of them has called Allocate().
   */
  void Build(vtkIdType lines);
  using Use = std::function<void(vtkIdType, Balls&)>;
  virtual void ForLines(vtkIdType begin, vtkIdType end, const Use& use) const = 0;
  virtual void Allocate(std::size_t count);
  virtual void Place(std::size_t i, const Piece& piece);
  ///@}

  const GlyphPlacement Placement;
  const bool FlatEnds, Joined;
  bool Moves = false; // each ball by itself
  rtg::GlyphInstances Instances;
  std::atomic<vtkIdType> Bad = 0;   // pieces and lines left out because something is wrong
  std::atomic<vtkIdType> Empty = 0; // pieces left out because their radii are zero

private:
  using Found = std::function<void(const Piece&)>;
  void Cut(vtkIdType line, Balls& balls, const Found& found);
};

} // namespace rtglyphs

#endif
