// Common code of the programs of images: the pixel of a launch, camera rays, and what a pixel gathers.
// Features that an image does not use are not in its program: on CPU devices even untaken branches cost time.
// Accumulation and exposure, which users turn on and off, are tested in the frame's record, once a pixel.
#include "../Shading/Frame.glsl"
#include "../Shading/Sampling.glsl"
#include "../Shading/ShutterTime.glsl"
#include "../Shading/Tone.glsl"

const uint tileSize = 8u;

// Launch index to pixel: tiles of 8 by 8 pixels, inside them blocks of 4 by 2, so that the eight lanes
// that lavapipe runs together see neighboring pixels. The tiles of a launch lie scattered over the image: each launch
// costs about as much as any other of its size, and so does each thread's part of it. False: no pixel is left.
bool LaunchPixel(const uvec2 launch, out uvec2 position)
{
  uint lane = launch.x & 63u;
  uint number = frame.firstTile + launch.y * (frame.launchWidth >> 6u) + (launch.x >> 6u);
  uint tile = (number * frame.tileStride) % frame.tileCount;
  uint block = lane >> 3u;
  uvec2 inBlock = uvec2(lane & 3u, (lane >> 2u) & 1u);
  uvec2 inTile = uvec2((block & 1u) * 4u, (block >> 1u) * 2u) + inBlock;
  position = uvec2(tile % frame.tileColumns, tile / frame.tileColumns) * tileSize + inTile;
  return number < frame.endTile && position.x < frame.width && position.y < frame.height;
}

// The sample's ray through a position in the pixel, in [0,1)^2. Its parameter is the view depth.
void CameraRay(const SampleNumber number, const vec2 position, out DoubleWord3 origin, out vec3 direction)
{
  vec2 ndc = 2.0 * (vec2(number.pixel) + position) / vec2(frame.width, frame.height) - 1.0;
  direction = frame.forward + ndc.x * frame.right + ndc.y * frame.up;
  origin = DoubleWord3(frame.eye, frame.eyeLow);
  if (frame.parallel != 0u)
  {
    origin = Add(origin, TwoProduct(frame.eyeRight, vec3(ndc.x)));
    origin = Add(origin, TwoProduct(frame.eyeUp, vec3(ndc.y)));
  }
  if (frame.lensRadius > 0.0)
  {
    // All rays of this position meet at the focus depth (Cook, Porter and Carpenter, "Distributed Ray Tracing", 1984).
    vec2 place = DiscPoint(SamplePair(number, pairLens));
    vec3 offset = (frame.lensRadius * place.x) * (cos(place.y) * frame.lensX + sin(place.y) * frame.lensY);
    origin = Add(origin, frame.lensAtEye * offset);
    direction -= frame.lensSlope * offset;
  }
}

// Chooses the time of a sample's whole path: of its camera ray, its occlusion rays and its bounces.
void OpenShutter(const SampleNumber number)
{
  if (moves)
  {
    shutterTime = ShutterTime(number);
  }
}

// A pixel's sums.
struct Pixel
{
  // Sums over samples of color times opacity, and of opacity. Single floats would be off by a hundredth after a
  // million samples, all to the same side.
  DoubleWord3 color;
  DoubleWord opacity;
  float missing; // of the light on the ground
  bool centerHit;
  float depth;       // view depth of the center's sample, or else of the nearest
  float opaqueDepth; // of the nearest opaque surface, in an image of translucent ones
  float behind;      // window depth of the ground, which rays do not hit
  uint record;       // its glyph set's, when a sample of this dispatch identified it; else `nothing`
  uint glyph;
};

Pixel BeginPixel(const uvec2 position)
{
  Pixel pixel = Pixel(Word3(vec3(0.0)), Word(0.0), 0.0, false, 1e38, 1e38, 1.0, nothing, nothing);
  if (frame.firstSample > 0u)
  {
    // Compilers may load it where there is one pixel only.
    uint at = frame.accumulates != 0u ? position.y * frame.width + position.x : 0u;
    pixel.color = DoubleWord3(frame.sums.at[at].color, frame.sums.at[at].colorLow);
    pixel.opacity = DoubleWord(frame.sums.at[at].opacity, frame.sums.at[at].opacityLow);
    pixel.missing = ground ? frame.sums.at[at].missing : 0.0;
    float depth = frame.sums.at[at].depth;
    pixel.centerHit = floatBitsToUint(depth) >> 31u != 0u;
    pixel.depth = abs(depth);
    pixel.opaqueDepth = layered || translucency ? frame.sums.at[at].opaqueDepth : 1e38;
  }
  return pixel;
}

// Adds a layer of a sample, or a whole sample.
void AddToPixel(inout Pixel pixel, const vec3 color, const float opacity)
{
  pixel.opacity = Add(pixel.opacity, opacity);
  // Beyond the range of floats there are no low parts.
  vec3 plain = pixel.color.hi + color;
  DoubleWord3 sum = Add(pixel.color, color);
  pixel.color.hi = mix(sum.hi, plain, isinf(plain));
  pixel.color.lo = mix(sum.lo, vec3(0.0), isinf(plain));
}

// Whether it is an opaque surface in an image of translucent ones: there is an image of opaque ones besides.
bool IsInOtherImage(const uint record)
{
  return (layered || translucency) && frame.cullMask == TRANSLUCENT_MASK && SetRecord(record).translucent == 0u;
}

// Whether this image shows such a surface, which a camera ray hits first, nevertheless. Where a translucent one lies
// behind it in the same pixel, at its edge, the other image shows the background: there this one has both, and is no
// farther than the nearest of them.
bool ShowsToo(inout Pixel pixel, const float viewDepth)
{
  pixel.opaqueDepth = min(pixel.opaqueDepth, viewDepth);
  return viewDepth < pixel.depth && pixel.depth < 1e38;
}

// Takes depth and identity from what a sample's camera ray has just hit, and adds it to the sums for denoising and
// scripts.
void Identify(inout Pixel pixel, const SampleNumber number, const SurfaceHit hit, const float viewDepth)
{
  bool center = number.index == 0u;
  if ((center || (!pixel.centerHit && viewDepth < pixel.depth)) && !IsInOtherImage(hit.record))
  {
    pixel.centerHit = center;
    pixel.depth = viewDepth;
    pixel.record = hit.record;
    pixel.glyph = hit.glyph;
  }
  if (gathersFeatures)
  {
    uint at = number.pixel.y * frame.width + number.pixel.x;
    frame.features.at[at].normal += hit.shadingNormal;
    frame.features.at[at].albedo += hit.color.rgb;
    frame.features.at[at].depth += viewDepth;
    frame.features.at[at].hits += 1.0;
  }
}

float WindowDepth(const float viewDepth)
{
  return frame.depthA + (frame.parallel != 0u ? frame.depthB * viewDepth : frame.depthB / viewDepth);
}

// Keeps and shows the pixel. `linear`: its color is light, not a display color.
void EndPixel(const uvec2 position, const Pixel pixel, const bool linear)
{
  uint at = position.y * frame.width + position.x;
  if (frame.accumulates != 0u)
  {
    frame.sums.at[at] = PixelSums(pixel.color.hi, pixel.color.lo, pixel.opacity.hi, pixel.opacity.lo, pixel.missing,
      pixel.centerHit ? -pixel.depth : pixel.depth, pixel.opaqueDepth);
  }

  vec4 shown = vec4(0.0);
  float samples = float(frame.firstSample + frame.samples);
  if (pixel.opacity.hi > 0.0)
  {
    vec3 mean = pixel.color.hi / pixel.opacity.hi;
    shown.rgb = linear || frame.mapsTones != 0u ? ToneMap(mean, linear, frame.exposureFactor, frame.toneMapping) : mean;
    shown.a = pixel.opacity.hi / samples;
  }
  if (ground)
  {
    shown = OverShadow(shown, pixel.missing / samples, linear);
  }
  float windowDepth = pixel.depth < 1e38 ? WindowDepth(pixel.depth) : shown.a > 0.0 ? pixel.behind : 1.0;
  if (pixel.opaqueDepth < 1e38)
  {
    // A little nearer: depth buffers round to 24 bits.
    windowDepth = min(windowDepth, WindowDepth(pixel.opaqueDepth) - 2.4e-7);
  }
  frame.color.at[at] = packUnorm4x8(shown);
  frame.depth.at[at] = windowDepth;
  // Earlier samples may have written already what is there.
  if (frame.firstSample == 0u || pixel.record != nothing)
  {
    frame.setIds.at[at] = pixel.record != nothing ? SetRecord(pixel.record).setId : nothing;
    frame.glyphIds.at[at] = pixel.glyph;
  }
}
