/**
 * @file    GlyphShapes.h
 * @brief   values of the property GlyphShape
 *
 * GLYPH_TYPE: what the property GlyphType is, exactly where a shape of the kernels is that (GlyphSource), else its
 * polygons.
 */
#ifndef GlyphShapes_h
#define GlyphShapes_h

namespace rtglyphs
{

struct GlyphShapes
{
  enum Values
  {
    GLYPH_TYPE = 0,
    SUPERQUADRIC = 5,
    TENSOR_ELLIPSOID = 6,
    TENSOR_SUPERQUADRIC = 7,
    SIGNED_TENSOR_SUPERQUADRIC = 8,
    CAPSULE = 10,
    NESTED_SUPERQUADRIC = 11,
    SPHERICAL_HARMONICS = 12,
    REYNOLDS = 13,
    FOURTH_ORDER_TENSOR = 14,
    PRINCIPAL_AXES = 15, // of tensors
    SPLIT_VECTOR = 16,
    UNCERTAIN_VECTOR = 17,     // with tensors as covariances
    CONFIDENCE_ELLIPSOID = 18, // of tensors as covariances
    UNCERTAIN_DIRECTION = 19   // with tensors as covariances
  };

  static constexpr const char* Known = "0, 5 to 8 and 10 to 19";
  static bool IsKnown(int shape)
  {
    return shape == GLYPH_TYPE || (shape >= SUPERQUADRIC && shape <= SIGNED_TENSOR_SUPERQUADRIC) ||
      (shape >= CAPSULE && shape <= UNCERTAIN_DIRECTION);
  }

  /// Whose axes are eigenvectors of a tensor.
  static bool IsTensor(int shape) { return shape >= TENSOR_ELLIPSOID && shape <= SIGNED_TENSOR_SUPERQUADRIC; }

  /// Spherical functions.
  static bool IsPolynomial(int shape) { return shape >= SPHERICAL_HARMONICS && shape <= FOURTH_ORDER_TENSOR; }

  /// Whose surfaces GlyphTensorColoring colors.
  static bool IsColored(int shape)
  {
    return IsTensor(shape) || IsPolynomial(shape) || shape == PRINCIPAL_AXES || shape == CONFIDENCE_ELLIPSOID;
  }

  static bool IsUncertain(int shape) { return shape == UNCERTAIN_VECTOR || shape == UNCERTAIN_DIRECTION; }

  /// Whose length and direction are a vector's, whatever Orient and Scaling are.
  static bool IsVector(int shape) { return shape == SPLIT_VECTOR || IsUncertain(shape); }
};

} // namespace rtglyphs

#endif
