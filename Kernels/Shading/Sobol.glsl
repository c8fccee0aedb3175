// Pseudo-random numbers and sequences whose first two dimensions are Sobol's, scrambled after Owen. Integers only, but
// for the last step, so that every device gets the same numbers.

// PCG's output function on a linear congruential step: the hash of best quality for its cost in Jarzynski and Olano,
// "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
RTG_FN uint Hash(const uint value)
{
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

RTG_FN uint Hash(const uint a, const uint b)
{
  return Hash(a ^ Hash(b));
}

// [0, 1) from the upper 24 bits: every one is a float.
RTG_FN float UnitInterval(const uint bits)
{
  return float(bits >> 8u) * 5.9604644775390625e-8;
}

// An Owen scramble of the number whose bits are reversed: each bit is flipped by a function of the lower ones.
// After Laine and Karras, "Stratified Sampling for Stochastic Transparency", EGSR 2011, with Vegdahl's
// constants ("Building a Better LK Hash", 2021).
RTG_FN uint ScrambleReversed(uint bits, uint seed)
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
RTG_FN uint PascalProduct(uint index)
{
  index ^= index >> 16u;
  index ^= (index & 0xff00ff00u) >> 8u;
  index ^= (index & 0xf0f0f0f0u) >> 4u;
  index ^= (index & 0xccccccccu) >> 2u;
  index ^= (index & 0xaaaaaaaau) >> 1u;
  return index;
}

// Each digit of two bits as an element a + b w of the field of four, w^2 = w + 1, times w.
RTG_FN uint TimesOmega(uint digits)
{
  uint a = digits & 0x55555555u;
  uint b = (digits >> 1u) & 0x55555555u;
  return b | ((a ^ b) << 1u);
}

// The same times w^power, power in 0 .. 2.
RTG_FN uint TimesOmega(uint digits, uint power)
{
  uint once = TimesOmega(digits);
  return power == 0u ? digits : power == 1u ? once : once ^ digits;
}

// Each digit of four bits as an element a + b z of the field of sixteen over that of four, z^2 = z + w, times z.
RTG_FN uint TimesZeta(uint digits)
{
  uint a = digits & 0x33333333u;
  uint b = (digits >> 2u) & 0x33333333u;
  return TimesOmega(b) | ((a ^ b) << 2u);
}

// Faure's generator matrix of the field's element e, times a sample's number: the digits are a polynomial's
// coefficients, and the wanted ones are those of f(t + e). Of halves f0 + t^s f1 the lower one gains e^s f1, then
// each half for itself.
RTG_FN uint ShiftedByOmega(uint number)
{
  number ^= TimesOmega(number & 0xffff0000u, 2u) >> 16u;
  number ^= TimesOmega(number & 0xff00ff00u) >> 8u;
  number ^= TimesOmega(number & 0xf0f0f0f0u, 2u) >> 4u;
  return number ^ (TimesOmega(number & 0xccccccccu) >> 2u);
}

// For e = z w^power; z^4 = z + 1.
RTG_FN uint ShiftedByZeta(uint number, uint power)
{
  uint high = number & 0xffff0000u;
  number ^= TimesOmega(TimesZeta(high) ^ high, power) >> 16u;
  high = number & 0xff00ff00u;
  number ^= TimesOmega(TimesZeta(high) ^ TimesOmega(high), (2u * power) % 3u) >> 8u;
  high = number & 0xf0f0f0f0u;
  return number ^ (TimesOmega(TimesZeta(high), power) >> 4u);
}

// Number `index` of a sequence of sixteen dimensions that `seed` chooses, as fractions of 2^32: the two of pair 0 .. 7.
// Every pair is a (0, 2)-sequence in base 2, pairs 2k and 2k + 1 together are a (0, 4)-sequence in base 4 and all a
// (0, 16)-sequence in base 16: any aligned 4^k numbers fill every cell of 4^k equal ones, whatever powers of 4 the four
// dimensions are cut into, once. That such sequences can be nested is due to Ahmed, Skopenkov, Hadwiger and Wonka,
// "SZ Sequences: Binary-based (0, 2^q)-Sequences", SIGGRAPH Asia 2024; the matrices here are Faure's ("Discrepance de
// suites associees a un systeme de numeration", Acta Arithmetica 41, 1982) in the fields of 2, 4 and 16 elements, each
// a subfield of the next. The order is shuffled and the values scrambled after Owen, which keeps all of this. Burley,
// "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
RTG_FN uvec2 ScrambledSobol(uint index, uint seed, uint pair)
{
  uint number = bitfieldReverse(ScrambleReversed(bitfieldReverse(index), seed));
  uint four = pair >> 1u;
  if (four > 0u)
  {
    number = ShiftedByZeta(number, four - 1u);
  }
  if ((pair & 1u) != 0u)
  {
    number = ShiftedByOmega(number);
  }
  uint own = Hash(seed + pair);
  return uvec2(bitfieldReverse(ScrambleReversed(number, Hash(own ^ 0x68bc21ebu))),
    bitfieldReverse(ScrambleReversed(PascalProduct(number), Hash(own ^ 0x02e5be93u))));
}

const uint pairsPerSequence = 8u;
