//VTK::System::Dec
//  Fragment shader of the full-viewport quad that draws pixels again where, or beside where, a ray-traced image is
//  seen.
//VTK::Output::Dec

uniform sampler2D imageColor;
uniform sampler2D imageDepth;
uniform vec2 depthMap; // as of ImageQuadFragments
uniform sampler2D pixels;

in vec2 texCoord;

void main()
{
  // FXAA mixes a pixel with its neighbors: background beside a smooth edge is kept, too.
  ivec2 size = textureSize(imageColor, 0);
  ivec2 pixel = ivec2(texCoord * vec2(size));
  float seen = 0.0;
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      seen = max(seen, texelFetch(imageColor, clamp(pixel + ivec2(x, y), ivec2(0), size - 1), 0).a);
    }
  }
  if (seen <= 0.0)
  {
    discard;
  }
  gl_FragDepth = depthMap.x * texture(imageDepth, texCoord).r + depthMap.y;
  gl_FragData[0] = texture(pixels, texCoord);
}
