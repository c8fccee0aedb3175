// What programs of the driver's structure know of the ray in flight; after bindings.glsl and glyph.glsl.

// The exact ray: its origin's low part travels beside it, because intersection programs cannot read the payload.
GlyphRay CurrentRay()
{
  return GlyphRay(gl_WorldRayOriginEXT, frame.rays.at[LaunchIndex()].originLow, gl_WorldRayDirectionEXT);
}

uint CurrentSeed()
{
  return translucency ? frame.rays.at[LaunchIndex()].seed : 0u;
}
