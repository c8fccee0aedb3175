//VTK::System::Dec
//RayTraced::Define
//  Fragment shader of the full-viewport quad that puts a ray-traced image into the view: its color, and
//  its depth in place of the quad's. Depth peeling replaces the tags where the image is translucent, and the view's
//  ambient occlusion in screen space (vtkSSAOPass) those that write the surface's place and normal.
//VTK::Output::Dec
//VTK::DepthPeeling::Dec

uniform sampler2D imageColor; // straight, not premultiplied
uniform sampler2D imageDepth; // window depth in [0, 1], of the camera that it was traced with
uniform vec2 depthMap;        // scale and offset, to window depth of the present camera

in vec2 texCoord;

#ifdef RAYTRACED_SURFACE
uniform mat4 clipToView; // inverse of the camera's projection

// The place that a pixel of the image shows, in the camera's coordinates.
vec3 PlaceOf(ivec2 pixel)
{
  vec2 position = (vec2(pixel) + 0.5) / vec2(textureSize(imageDepth, 0));
  float depth = depthMap.x * texelFetch(imageDepth, pixel, 0).r + depthMap.y;
  vec4 place = clipToView * vec4(2.0 * vec3(position, depth) - 1.0, 1.0);
  return place.xyz / place.w;
}

// The step along the surface from a pixel to its neighbor: of the two neighbors the one of more like depth, because the
// other may show another surface.
vec3 StepAlong(ivec2 direction, ivec2 pixel, vec3 place)
{
  ivec2 size = textureSize(imageDepth, 0);
  bool first = any(lessThan(pixel - direction, ivec2(0)));
  bool last = any(greaterThanEqual(pixel + direction, size));
  vec3 forth = last ? vec3(0.0) : PlaceOf(pixel + direction) - place;
  vec3 back = first ? vec3(0.0) : place - PlaceOf(pixel - direction);
  return last || (!first && abs(back.z) < abs(forth.z)) ? back : forth;
}
#endif

#ifdef RAYTRACED_COARSE
// The image has fewer pixels than the viewport: of the four around a place colors are interpolated, and the depth is
// that of the frontmost.
void Shown(out vec4 color, out float depth)
{
  ivec2 size = textureSize(imageColor, 0);
  vec2 place = texCoord * vec2(size) - 0.5;
  ivec2 first = ivec2(floor(place));
  vec2 second = place - vec2(first);
  color = vec4(0.0);
  depth = 1.0;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 side = ivec2(i & 1, i >> 1);
    ivec2 pixel = clamp(first + side, ivec2(0), size - 1);
    vec2 weights = mix(1.0 - second, second, vec2(side));
    vec4 of = texelFetch(imageColor, pixel, 0);
    color += weights.x * weights.y * of.a * vec4(of.rgb, 1.0);
    depth = of.a > 0.0 ? min(depth, texelFetch(imageDepth, pixel, 0).r) : depth;
  }
  color.rgb /= max(color.a, 1e-6);
}
#else
void Shown(out vec4 color, out float depth)
{
  color = texture(imageColor, texCoord);
  depth = texture(imageDepth, texCoord).r;
}
#endif

void main()
{
  vec4 color;
  float depth;
  Shown(color, depth);
  if (color.a <= 0.0)
  {
    discard;
  }
  gl_FragDepth = depthMap.x * depth + depthMap.y;
#ifdef RAYTRACED_SURFACE
  // These names are those of VTK's own shaders, which vtkSSAOPass looks for.
  ivec2 pixel = ivec2(texCoord * vec2(textureSize(imageDepth, 0)));
  vec4 vertexVC = vec4(PlaceOf(pixel), 1.0);
  vec3 normalVCVSOutput =
    normalize(cross(StepAlong(ivec2(1, 0), pixel, vertexVC.xyz), StepAlong(ivec2(0, 1), pixel, vertexVC.xyz)));
#endif
  //VTK::Light::Impl
  //VTK::DepthPeeling::PreColor
  gl_FragData[0] = color;
  //VTK::DepthPeeling::Impl
}
