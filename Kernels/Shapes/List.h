// The analytic shapes by number, below 32: one text for C++ (rtg::Shape) and GLSL. Each is described in
// Shapes/<Name>.glsl. A number that the property GlyphShape has, too, means the same there (state files keep it) or,
// from 6 to 9, a tensor glyph or a mesh; 13 and 14 are polynomials, too.
#ifndef RTG_SHAPE_LIST
#define RTG_SHAPE_LIST

#define RTG_SHAPES(ENTRY)                                                                                              \
  ENTRY(0, Sphere)                                                                                                     \
  ENTRY(1, Box)                                                                                                        \
  ENTRY(2, Cylinder)                                                                                                   \
  ENTRY(3, Cone)                                                                                                       \
  ENTRY(4, Arrow)                                                                                                      \
  ENTRY(5, Superquadric)                                                                                               \
  ENTRY(6, NestedSuperquadric)                                                                                         \
  ENTRY(10, Capsule)                                                                                                   \
  ENTRY(11, RoundCone)                                                                                                 \
  ENTRY(12, Polynomial)                                                                                                \
  ENTRY(20, SweptEllipsoid)

// Bits of convex shapes, which a ray enters and leaves once.
#define RTG_CONVEX_SHAPES 0x100c0f

// The shape that has an estimate of its own: RoundCone.
#define RTG_OWN_ESTIMATE 11

// SweptEllipsoid, whose ends' distance is not its size.
#define RTG_SWEPT 20

// A mesh, which is no analytic shape.
#define RTG_MESH 7

#endif
