// SPDX-License-Identifier: MIT
// A noise on texture coordinates: where it is evaluated, and how its slopes become normals.
// uv (float2) and its screen-space gradients -> LichenPlace; slopes (float2) -> normal in tangent
// space; what of them a pixel hides -> roughness.
#ifndef LICHEN_UV_GLSL
#define LICHEN_UV_GLSL

#include "../noise/method.glsl"
#include "../noise/texton_gradient.glsl"
#include "../noise/tile_frame.glsl"

/// The weight of a mix at `uv` where it is a constant or a direction; 0 of other sources, which
/// lichenSetMix and lichenMixByMask are for.
void lichenMixByUv(inout LichenImpacts impacts, vec2 uv, LichenNoise noise, LichenTexton texton) {
  impacts.mixWeight = lichenMixWeight(uv, texton);
  // By tile coordinates: the transposed inverse of a rotation with a scale is itself over the
  // scale's square.
  vec2 row = vec2(noise.uvToTileXX, noise.uvToTileXY);
  impacts.mixGradient =
      lichenUvToTile(vec2(texton.mixPerU, texton.mixPerV), noise) / dot(row, row);
}

/// The place at `uv` with explicit gradients: usable in compute and in non-uniform control flow.
LichenPlace lichenPlaceUvGrad(vec2 uv, vec2 uvGradientX, vec2 uvGradientY, LichenNoise noise,
                              LichenTexton texton) {
  vec2 position = vec2(noise.offsetX, noise.offsetY) + lichenUvToTile(uv, noise);
  LichenPlace place = lichenPlaceAt(position, lichenUvToTile(uvGradientX, noise),
                                    lichenUvToTile(uvGradientY, noise), noise, texton);
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsMix(texton))
    lichenMixByUv(place.impacts, uv, noise, texton);
#endif
  return place;
}

/// The impacts for lichenTextonGradient at `uv`, likewise.
LichenImpacts lichenGradientPlaceUvGrad(vec2 uv, vec2 uvGradientX, vec2 uvGradientY,
                                        LichenNoise noise, LichenTexton texton) {
  vec2 position = vec2(noise.offsetX, noise.offsetY) + lichenUvToTile(uv, noise);
  LichenImpacts impacts =
      lichenGradientImpactsAt(position, lichenUvToTile(uvGradientX, noise),
                              lichenUvToTile(uvGradientY, noise), noise, texton);
  lichenMixByUv(impacts, uv, noise, texton);
  return impacts;
}

/// The unit tangent-space normal of slopes (-nx/nz, -ny/nz).
vec3 lichenNormalFromSlopes(vec2 slopes) { return normalize(vec3(-slopes, 1.0)); }

/// The perceptual roughness of a microfacet surface whose slopes vary by `slopeVariance`, along
/// each axis, where the footprint does not show it: a slope map's z, times the square of what
/// multiplies the slopes. Neither rotation nor scale of the texture coordinates changes it.
float lichenRoughness(float roughness, float slopeVariance) {
  // [OB10] section 3, [TK19] eq. 3: a facet's slopes have the variance alpha^2 / 2 along each axis
  // (of GGX, the Beckmann's that it stands for), and variances add.
  float alpha = roughness * roughness;
  return sqrt(sqrt(min(1.0, alpha * alpha + 2.0 * max(0.0, slopeVariance))));
}

#endif
