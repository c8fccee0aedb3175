/**
 * What the name of an array says it is, in the words of simulation codes. Words are told apart by case, digits and
 * punctuation: 'c_radius', 'ParticleRadius' and 'radius2' speak of a radius, 'radiation' does not.
 */
#ifndef GlyphArrayNames_h
#define GlyphArrayNames_h

#include <string>

namespace rtglyphs::GlyphArrayNames
{
bool IsRadius(const std::string& name);
bool IsDiameter(const std::string& name);
bool IsVelocity(const std::string& name);
bool IsNormal(const std::string& name);
bool IsQuaternion(const std::string& name);

/**
 * Of three components: 0 what an arrow surely should follow (velocity before displacement, force, normal and others,
 * which have higher numbers), -1 what has no direction, as positions, angles, colors, lengths; `unknown` all others.
 */
constexpr int unknown = 100;
int DirectionRank(const std::string& name);

/**
 * Of six or nine components: 0 a tensor by its name, `unknown` maybe one, -1 a rotation.
 */
int TensorRank(const std::string& name);

/**
 * A number that only tells things apart, such as an id.
 */
bool IsLabel(const std::string& name);
}

#endif
// VTK-HeaderTest-Exclude: GlyphArrayNames.h
