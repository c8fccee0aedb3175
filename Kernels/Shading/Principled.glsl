// How a surface scatters light: Burley's principled model ("Physically Based Shading at Disney", SIGGRAPH 2012) in
// layers from above: a coat, then metal or a dielectric's reflection, then diffuse. Sheen, subsurface and anisotropy
// are left out.
//
// Different from the paper: no layer loses or makes energy, so that a white surface in white light is
// invisible.
// - Light that facets reflect onto each other goes to the layer below, and leaves metal as a diffuse lobe.
// - What a layer reflects is missing below it.
// - The diffuse lobe is divided by its albedo, which is a polynomial (DiffuseAlbedo).
// Directions are unit vectors in the surface's frame, z the normal; both point away from the surface, z > 0.
//
// Layers are chosen at random, by the same numbers u in both functions: Scatter() draws a direction, and
// the mean of Evaluate() over u is the density that Scatter() draws times its weight.

struct Surface
{
  vec3 base;          // linear, [0, 1]
  float metallic;     // [0, 1]: probability of metal
  float roughness;    // [0, 1]
  float reflectance;  // of the dielectric at normal incidence
  vec3 specularColor; // tints the dielectric's reflection
  float coat;         // [0, 1]: weight of the coat's reflection
  float coatRoughness;
  float coatReflectance; // at normal incidence
  vec3 coatColor;        // tints what passes the coat
};

// Independent uniform numbers in [0,1)^2.
struct ScatterNumbers
{
  vec2 direction;
  vec2 lobe; // coat or not; metal or not, then reflection or diffuse
  vec2 facet;
  vec2 coatFacet;
  vec2 chance; // escape from the coat's and the base's facets
};

const float scatterPi = 3.14159265358979324;

// Width of the facets' distribution. A perfect mirror is a very smooth one.
RTG_FN float FacetWidth(float roughness)
{
  return max(roughness * roughness, 0.001f);
}

RTG_FN float FifthPower(float x)
{
  float square = x * x;
  return square * square * x;
}

// Schlick's approximation. Where next to nothing is reflected at normal incidence, less is at grazing incidence, too,
// down to nothing: what has the refractive index of air is not seen (Lagarde and de Rousiers, "Moving Frostbite to
// Physically Based Rendering", 2014).
RTG_FN float Fresnel(float reflectance, float cosine)
{
  float grazing = min(50.0f * reflectance, 1.0f);
  return reflectance + (grazing - reflectance) * FifthPower(1.0f - min(abs(cosine), 1.0f));
}

// Smith's function of the GGX distribution: facets that block the view, per facet that does not.
RTG_FN float SmithLambda(vec3 v, float width)
{
  float tangent = width * width * (v.x * v.x + v.y * v.y) / (v.z * v.z);
  // (sqrt(1 + a) - 1) / 2 without cancellation.
  return 0.5f * tangent / (sqrt(1.0f + tangent) + 1.0f);
}

// Fraction of facets with normal m visible from `to`, of those visible from `from`.
RTG_FN float EscapeProbability(vec3 from, vec3 to, float width)
{
  if (to.z <= 0.0f)
  {
    return 0.0f;
  }
  float lambda = SmithLambda(from, width);
  return (1.0f + lambda) / (1.0f + lambda + SmithLambda(to, width));
}

// Normal of a facet, as often as `from` sees it. Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical
// Caps", HPG 2023.
RTG_FN vec3 VisibleFacet(vec3 from, float width, vec2 u)
{
  vec3 stretched = normalize(vec3(width * from.x, width * from.y, from.z));
  float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
  float radius = sqrt(max(1.0f - z * z, 0.0f));
  // Between -pi and pi, where sine and cosine are specified.
  float angle = 2.0f * scatterPi * (u.x < 0.5f ? u.x : u.x - 1.0f);
  vec3 halfway = vec3(radius * cos(angle), radius * sin(angle), z) + stretched;
  return normalize(vec3(width * halfway.x, width * halfway.y, max(halfway.z, 1e-7f)));
}

// Density times cosine of light that leaves once reflected, without the Fresnel factor.
RTG_FN float FacetReflection(vec3 from, vec3 to, vec3 m, float width)
{
  float x = m.x / width;
  float y = m.y / width;
  float d = x * x + y * y + m.z * m.z;
  float distribution = 1.0f / (scatterPi * width * width * d * d);
  return distribution / (4.0f * from.z * (1.0f + SmithLambda(from, width) + SmithLambda(to, width)));
}

// Burley's diffuse lobe relative to Lambert's.
RTG_FN float DiffuseShape(vec3 from, vec3 to, float roughness)
{
  // FD90 - 1 with 2 cos^2(theta_d) = 1 + from . to
  float grazing = roughness * (1.0f + dot(from, to)) - 0.5f;
  return (1.0f + grazing * FifthPower(1.0f - to.z)) * (1.0f + grazing * FifthPower(1.0f - from.z));
}

// Mean of DiffuseShape over cosine-distributed `to`. With K = roughness - 1/2, r = roughness, c = from.z, x = to.z, and
// from . to of mean c x and mean square c^2 x^2 + (1 - c^2)(1 - x^2) / 2 about the normal, it is a sum of
// integrals of 2 x^n (1 - x)^5: 1/21, 1/84, 1/252 for n = 1, 2, 3.
RTG_FN float DiffuseAlbedo(float c, float r)
{
  float k = r - 0.5f;
  float a = k / 21.0f + r * c / 84.0f;
  float b = k + r * c * (2.0f / 3.0f);
  float ab = k * k / 21.0f + 2.0f * k * r * c / 84.0f +
    r * r * (c * c / 252.0f + 0.5f * (1.0f - c * c) * (1.0f / 21.0f - 1.0f / 252.0f));
  return 1.0f + a + FifthPower(1.0f - c) * (b + ab);
}

// Fresnel color of metal at a facet; and of metal that reflects light a second time, on average over all angles.
RTG_FN vec3 MetalFresnel(vec3 base, float cosine)
{
  return base + (vec3(1.0f) - base) * FifthPower(1.0f - min(abs(cosine), 1.0f));
}

RTG_FN vec3 MetalAverage(vec3 base)
{
  return base + (vec3(1.0f) - base) / 21.0f;
}

// Probability that a layer reflects the light that came from `from` to its facet m.
RTG_FN float LayerReflection(float strength, float reflectance, float width, vec3 from, vec3 m)
{
  vec3 to = reflect(-from, m);
  return strength * Fresnel(reflectance, dot(from, m)) * EscapeProbability(from, to, width);
}

RTG_FN vec3 CoatTint(Surface surface)
{
  return vec3(1.0f) + surface.coat * (surface.coatColor - vec3(1.0f));
}

// Approximate fraction of environment light that a surface reflects at that angle, all layers together: as if each
// were smooth. White stays white.
RTG_FN vec3 AlbedoSeen(Surface surface, float cosine)
{
  float facets = (1.0f - surface.metallic) * Fresnel(surface.reflectance, cosine);
  float coat = surface.coat * Fresnel(surface.coatReflectance, cosine);
  vec3 below = facets * surface.specularColor + (1.0f - facets) * surface.base;
  return vec3(coat) + (1.0f - coat) * CoatTint(surface) * below;
}

// Draws the direction that light, followed back from `from`, came from; returns its weight.
RTG_FN vec3 Scatter(Surface surface, vec3 from, ScatterNumbers u, RTG_OUT(vec3) to)
{
  vec3 weight = vec3(1.0f);
  if (surface.coat > 0.0f)
  {
    float width = FacetWidth(surface.coatRoughness);
    vec3 m = VisibleFacet(from, width, u.coatFacet);
    if (u.lobe.x < LayerReflection(surface.coat, surface.coatReflectance, width, from, m))
    {
      to = reflect(-from, m);
      return weight;
    }
    weight = CoatTint(surface);
  }

  float width = FacetWidth(surface.roughness);
  if (u.lobe.y < surface.metallic)
  {
    vec3 m = VisibleFacet(from, width, u.facet);
    weight *= MetalFresnel(surface.base, dot(from, m));
    to = reflect(-from, m);
    if (u.chance.x >= EscapeProbability(from, to, width))
    {
      to = CosineDirection(u.direction);
      weight *= MetalAverage(surface.base);
    }
    return weight;
  }

  if (surface.reflectance > 0.0f)
  {
    vec3 m = VisibleFacet(from, width, u.facet);
    if (u.chance.x < LayerReflection(1.0f, surface.reflectance, width, from, m))
    {
      to = reflect(-from, m);
      return weight * surface.specularColor;
    }
  }
  to = CosineDirection(u.direction);
  return weight * surface.base * (DiffuseShape(from, to, surface.roughness) / DiffuseAlbedo(from.z, surface.roughness));
}

// Reflected radiance from `to`, a given direction, per unit of irradiance across it: the density times the cosine.
RTG_FN vec3 Evaluate(Surface surface, vec3 from, vec3 to, ScatterNumbers u)
{
  vec3 sum = vec3(0.0f);
  vec3 weight = vec3(1.0f);
  vec3 middle = normalize(from + to);
  float cosine = dot(from, middle);
  float lambert = to.z / scatterPi;
  if (surface.coat > 0.0f)
  {
    float width = FacetWidth(surface.coatRoughness);
    sum += vec3(surface.coat * Fresnel(surface.coatReflectance, cosine) * FacetReflection(from, to, middle, width));
    vec3 m = VisibleFacet(from, width, u.coatFacet);
    weight = CoatTint(surface) * (1.0f - LayerReflection(surface.coat, surface.coatReflectance, width, from, m));
  }

  float width = FacetWidth(surface.roughness);
  if (u.lobe.y < surface.metallic)
  {
    vec3 m = VisibleFacet(from, width, u.facet);
    float trapped = 1.0f - EscapeProbability(from, reflect(-from, m), width);
    return sum +
      weight *
      (MetalFresnel(surface.base, cosine) * FacetReflection(from, to, middle, width) +
        MetalFresnel(surface.base, dot(from, m)) * MetalAverage(surface.base) * (trapped * lambert));
  }

  if (surface.reflectance > 0.0f)
  {
    vec3 m = VisibleFacet(from, width, u.facet);
    sum += weight * surface.specularColor *
      (Fresnel(surface.reflectance, cosine) * FacetReflection(from, to, middle, width));
    weight *= 1.0f - LayerReflection(1.0f, surface.reflectance, width, from, m);
  }
  return sum +
    weight * surface.base *
    (lambert * DiffuseShape(from, to, surface.roughness) / DiffuseAlbedo(from.z, surface.roughness));
}
