//VTK::System::Dec
//  Fragment shader of the full-viewport quad that draws pixels again where a ray-traced image is seen.
//VTK::Output::Dec

uniform sampler2D imageColour;
uniform sampler2D imageDepth; // window depth in [0, 1]
uniform sampler2D pixels;

in vec2 texCoord;

void main()
{
  if (texture(imageColour, texCoord).a <= 0.0)
  {
    discard;
  }
  gl_FragDepth = texture(imageDepth, texCoord).r;
  gl_FragData[0] = texture(pixels, texCoord);
}
