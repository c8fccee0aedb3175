// When the light path of a sample runs: one time for its camera ray, its occlusion rays and its bounces.

// A seed that no pair of dimensions uses.
const uint timeSeed = 0x7f4a7c15u;

// Local shading: the parts of the opening that the planned samples have one each of, and of them the one of a sample,
// by steps of about the golden section, so that an image that grows has early and late times from the start. All pixels
// go through the parts in the same order: their rays meet the same version of the glyphs' trees.
uint TimeStratum(const uint index)
{
  return index % frame.timeStrata * frame.timeStep % frame.timeStrata;
}

// The place in the pixel of a sample with that number. Places follow a sequence in the order of time: then place and
// time together are spread evenly, as Hammersley's points are, and not only each by itself.
uint PlaceAmongTimes(const uint index)
{
  return frame.timeStrata > 0u ? TimeStratum(index) + index / frame.timeStrata * frame.timeStrata : index;
}

// Fraction of the shutter's opening, in [0, 1).
//
// Without strata the times of a pixel are an Owen-scrambled radical inverse: any aligned 2^k samples have one
// in each of 2^k equal parts. Their first frame.sharedTimeBits binary digits are scrambled alike for all pixels, so
// that in one sample all rays fall into one part, where they meet one version of the glyphs' trees and, on CPU devices,
// neighboring lanes take the same path through it; the digits after them belong to each pixel.
float ShutterTime(const SampleNumber number)
{
  uint pixelSeed = Hash(timeSeed ^ Hash(number.pixel.x, number.pixel.y));
  if (frame.timeStrata > 0u)
  {
    float at = float(TimeStratum(number.index)) + UnitInterval(Hash(pixelSeed, number.index));
    return min(at / float(frame.timeStrata), 0.99999994);
  }
  if (independentSamples)
  {
    return UnitInterval(Hash(pixelSeed, number.index));
  }
  uint shared_ = ScrambledSobol(number.index, timeSeed, 0u).x;
  uint own = 0xffffffffu >> frame.sharedTimeBits;
  uint scrambled = bitfieldReverse(ScrambleReversed(bitfieldReverse(shared_), pixelSeed));
  return UnitInterval((shared_ & ~own) | (scrambled & own));
}
