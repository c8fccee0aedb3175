// Pseudo-random numbers and the first two dimensions of the Sobol sequence, scrambled after Owen. Integers only, but for
// the last step, so that every device gets the same numbers.
#ifndef RTG_SOBOL
#define RTG_SOBOL

#ifndef RTG_SHADING_HOST
#include "Dialect.glsl"
#endif

// PCG's output function on a linear congruential step: the hash of best quality for its cost in Jarzynski and Olano,
// "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
RTG_SHADING_FN uint Hash(uint value)
{
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

RTG_SHADING_FN uint Hash(uint a, uint b)
{
  return Hash(a ^ Hash(b));
}

// [0, 1) from the upper 24 bits: every one is a float.
RTG_SHADING_FN float UnitInterval(uint bits)
{
  return float(bits >> 8u) * 5.9604644775390625e-8;
}

// An Owen scramble of the number whose bits are reversed: each bit is flipped by a function of the lower ones.
// After Laine and Karras, "Stratified Sampling for Stochastic Transparency", EGSR 2011, with Vegdahl's
// constants ("Building a Better LK Hash", 2021).
RTG_SHADING_FN uint ScrambleReversed(uint bits, uint seed)
{
  bits ^= bits * 0x3d20adeau;
  bits += seed;
  bits *= (seed >> 16u) | 1u;
  bits ^= bits * 0x05526c56u;
  bits ^= bits * 0x53a22864u;
  return bits;
}

// The second Sobol dimension of a sample's number, bits reversed: its generator matrix is Pascal's triangle modulo 2,
// whose two halves' product with the number are those of the halves' size.
RTG_SHADING_FN uint PascalProduct(uint index)
{
  index ^= index >> 16u;
  index ^= (index & 0xff00ff00u) >> 8u;
  index ^= (index & 0xf0f0f0f0u) >> 4u;
  index ^= (index & 0xccccccccu) >> 2u;
  index ^= (index & 0xaaaaaaaau) >> 1u;
  return index;
}

// Number `index` of the two-dimensional sequence that `seed` chooses, as fractions of 2^32: the order is
// shuffled and the values scrambled, which keeps every aligned run of 2^k numbers a (0, k, 2)-net.
// Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
RTG_SHADING_FN uvec2 ScrambledSobol(uint index, uint seed)
{
  uint shuffled = bitfieldReverse(ScrambleReversed(bitfieldReverse(index), seed));
  return uvec2(bitfieldReverse(ScrambleReversed(shuffled, Hash(seed ^ 0x68bc21ebu))),
    bitfieldReverse(ScrambleReversed(PascalProduct(shuffled), Hash(seed ^ 0x02e5be93u))));
}

// Where `index` goes in a permutation of 0 .. count - 1 that `seed` chooses: rounds of steps that are invertible
// modulo a power of two, repeated until the result is one of the count (Black and Rogaway's cycle walking).
RTG_SHADING_FN uint Permuted(uint index, uint count, uint seed)
{
  uint mask = count - 1u;
  mask |= mask >> 1u;
  mask |= mask >> 2u;
  mask |= mask >> 4u;
  mask |= mask >> 8u;
  mask |= mask >> 16u;
  uint half_ = (uint(bitCount(mask)) + 1u) / 2u;
  do
  {
    for (uint turn = 0u; turn < 3u; ++turn)
    {
      index = (index * (Hash(seed + 2u * turn) | 1u) + Hash(seed + 2u * turn + 1u)) & mask;
      index ^= index >> half_;
    }
  } while (index >= count);
  return index;
}

// Number `index` of a planned `count`: jittered in the cells of a grid of about square cells, their order shuffled.
// Numbers beyond the grid are independent.
RTG_SHADING_FN uvec2 Stratified(uint index, uint count, uint seed)
{
  uvec2 random = uvec2(Hash(index, seed), Hash(index, seed ^ 0x9e3779b9u));
  uint columns = uint(floor(sqrt(float(max(count, 1u)))));
  uint rows = max(count, 1u) / columns;
  if (index >= rows * columns)
  {
    return random;
  }
  uint cell = Permuted(index, rows * columns, seed);
  // (cell's number + random fraction) / cells, in integers.
  uint width = 0xffffffffu / columns;
  uint height = 0xffffffffu / rows;
  return uvec2((cell % columns) * width + uint(float(width) * UnitInterval(random.x)),
    (cell / columns) * height + uint(float(height) * UnitInterval(random.y)));
}

#endif
