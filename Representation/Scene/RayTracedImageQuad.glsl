//VTK::System::Dec
// Fragment shader of the full-viewport quad that puts a ray-traced image into the view: its colour, and
// its depth in place of the quad's. Depth peeling replaces the tags where the image is translucent.
//VTK::Output::Dec
//VTK::DepthPeeling::Dec

uniform sampler2D imageColour; // straight, not premultiplied
uniform sampler2D imageDepth;  // window depth in [0, 1]

in vec2 texCoord;

void main()
{
  vec4 colour = texture(imageColour, texCoord);
  if (colour.a <= 0.0)
  {
    discard;
  }
  gl_FragDepth = texture(imageDepth, texCoord).r;
  //VTK::DepthPeeling::PreColor
  gl_FragData[0] = colour;
  //VTK::DepthPeeling::Impl
}
