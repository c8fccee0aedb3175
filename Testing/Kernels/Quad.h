// Numbers of 113 bits: the compiler's __float128 with GCC's libquadmath, or long double where it has as many.
#pragma once

#include <cfloat>
#include <cmath>

#if LDBL_MANT_DIG == 113
#define asinq asinl
#define atan2q atan2l
#define atanq atanl
#define cosq cosl
#define exp2q exp2l
#define expq expl
#define fabsq fabsl
#define logq logl
#define powq powl
#define sinq sinl
#define sqrtq sqrtl
#else
#include <quadmath.h>
#endif

namespace rtg::testing
{

#if LDBL_MANT_DIG == 113
using Quad = long double;
#else
using Quad = __float128;
#endif

} // namespace rtg::testing
