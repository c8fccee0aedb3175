// Frame.glsl, Sobol.glsl, Principled.glsl and Tone.glsl as C++, from the same text that the GPU runs.
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace rtg::shading
{

using glm::bitCount;
using glm::bitfieldReverse;
using glm::clamp;
using glm::dot;
using glm::lessThanEqual;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::reflect;
using glm::uvec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using std::abs;
using std::cos;
using std::floor;
using std::sin;
using std::sqrt;
using uint = glm::uint;

#define RTG_FN inline
#define RTG_OUT(type) type&

#include "Frame.glsl"
#include "Principled.glsl"
#include "Sobol.glsl"
#include "Tone.glsl"

#undef RTG_FN
#undef RTG_OUT

} // namespace rtg::shading
