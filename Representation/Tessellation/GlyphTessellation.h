/**
 * Triangles of the unit glyphs (Kernels/Shapes), for exporters: analytic shapes have none of their own.
 *
 * Corners lie on the surface; normals are the surface's, and edges are sharp.
 */
#ifndef GlyphTessellation_h
#define GlyphTessellation_h

#include "Glyphs.h"
#include "TriangleMesh.h"

namespace rtglyphs::GlyphTessellation
{
///@{
/// The unit glyphs of the same name; of a sphere also the half toward +x, open at x = 0. The parts that capsules and
/// arrows consist of follow.
rtg::TriangleMesh Sphere(bool half = false);
rtg::TriangleMesh Box();
rtg::TriangleMesh Cylinder();
rtg::TriangleMesh Cone();
///@}

/// A cone around the x axis of radius 1 at 0 and `ratio` at 1, of ratio 1 a cylinder; `open`: without its discs.
rtg::TriangleMesh CutCone(double ratio, bool open);

/// The head of a unit arrow, with its tip at the origin, toward +x.
rtg::TriangleMesh ArrowHead(const rtg::ArrowForm& form);

///@{
/// |x|^r + |y|^s + |z|^t = 1, and Kernels/Shapes/NestedSuperquadric.glsl of exponents alpha, beta, c; with half-lengths
/// 0.5. `facets`: from pole to pole, an even number; twice as many around.
rtg::TriangleMesh Superquadric(const glm::vec3& exponents, int facets);
rtg::TriangleMesh NestedSuperquadric(const glm::vec3& exponents, int facets);
///@}

/// Kernels/Shapes/SweptEllipsoid.glsl of one of the glyphs, in its frame and size.
rtg::TriangleMesh SweptEllipsoid(const rtg::GlyphInstances& instances, std::size_t glyph);
}

#endif
