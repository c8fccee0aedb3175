// Where the samples of a pixel lie. Deterministic: functions of the pixel, the sample's number and the dimension alone.

// Sample s >= 1 in [0,1)^2: the R2 sequence (Roberts 2018, the plastic number's additive recurrence) started at the
// pixel's center, so that with sample 0 there the first samples spread evenly round it. In integers, of which the
// overflow is the recurrence's own: floats would round the places of late samples to a coarse grid.
vec2 PixelSample(const uint s)
{
  uvec2 bits = 0x80000000u + s * uvec2(3242174889u, 2447445414u); // 0.7548776662466927, 0.5698402909980532
  return vec2(UnitInterval(bits.x), UnitInterval(bits.y));
}

// The pairs in use. Those that matter together are of one sequence, and the place in the pixel and the first direction
// its best four dimensions.
const uint pairPixel = 0u;
const uint pairLens = pairsPerSequence * 0x2000u; // in a sequence of its own
// of one bounce
const uint pairDirection = 0u;
const uint pairLobe = 1u; // metal or not, coat or base
const uint pairFacet = 2u;
const uint pairCoatFacet = 3u;
const uint pairChance = 4u; // escape from between facets
const uint pairLight = 5u;  // which one; whether the path goes on at the next hit
const uint pairToLight =
  6u; // at the environment image: the cell, and the next pair: where in it; at a light of some width

uint PairOf(const uint bounce, const uint purpose)
{
  // The first sequence: place and first direction; next two directions; facet and chance; lobe and fourth direction.
  if (purpose == pairDirection)
  {
    return bounce < 3u ? 1u + bounce : bounce == 3u ? 7u : pairsPerSequence * 0x1000u + bounce - 4u;
  }
  if (bounce == 0u && (purpose == pairLobe || purpose == pairFacet || purpose == pairChance))
  {
    return purpose == pairFacet ? 4u : purpose == pairChance ? 5u : 6u;
  }
  return pairsPerSequence * (bounce + 1u) + purpose;
}

// One sample of one pixel; its dimensions come in pairs.
struct SampleNumber
{
  uvec2 pixel;
  uint index;
};

// The pair number `pair` in [0,1)^2. Different pairs and different pixels are independent of each other.
vec2 SamplePair(const SampleNumber number, const uint pair)
{
  uvec2 bits;
  if (independentSamples)
  {
    uint pixelSeed = Hash(pair * 0x9e3779b9u ^ Hash(number.pixel.x, number.pixel.y));
    bits = uvec2(Hash(pixelSeed, 2u * number.index), Hash(pixelSeed, 2u * number.index + 1u));
  }
  else
  {
    uint sequenceSeed = Hash((pair / pairsPerSequence) * 0x9e3779b9u ^ Hash(number.pixel.x, number.pixel.y));
    bits = ScrambledSobol(number.index, sequenceSeed, pair % pairsPerSequence);
    if (pair == pairPixel || pair == pairLens)
    {
      // Sample 0 goes through the pixel's center and the lens's. A shift by digits puts it there and keeps the net;
      // turned round in half of the pixels, because such a net leans to one side.
      bits ^= ScrambledSobol(0u, sequenceSeed, pair % pairsPerSequence);
      bits ^= (sequenceSeed & 1u) != 0u ? 0x7fffffffu : 0x80000000u;
    }
  }
  return vec2(UnitInterval(bits.x), UnitInterval(bits.y));
}

// A seed of independent numbers, for what has no bounded dimension; never 0.
uint SeedOf(const SampleNumber number, const uint event)
{
  return Hash(Hash(number.pixel.x, number.pixel.y), Hash(number.index, event)) | 1u;
}

// Where in the pixel the sample's camera ray goes through; sample 0 is the middle.
vec2 PixelPosition(const SampleNumber number)
{
  return number.index == 0u ? vec2(0.5) : SamplePair(number, pairPixel);
}
