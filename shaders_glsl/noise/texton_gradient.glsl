// SPDX-License-Identifier: MIT
// A map's first channel and its derivatives, for bumps of a height: impacts around a point ->
// (value, d/dx, d/dy), of the stored value and per tile. Where a texton of order 3 is magnified the
// derivatives are the spline's own, continuous; otherwise differences over a texel of the level.
// [GLM17] section 5, bump mapping; [UAE93] for the derivative of a B-spline.
#ifndef LICHEN_TEXTON_GRADIENT_GLSL
#define LICHEN_TEXTON_GRADIENT_GLSL

#include "texton.glsl"

/// Weights of four neighbouring texels, `f` [0, 1) beyond the second one's centre: of the cubic
/// B-spline.
vec4 lichenCubicWeights(float f) {
  float r = 1.0 - f;
  return vec4(r * r * r, 4.0 - 3.0 * f * f * (1.0 + r), 4.0 - 3.0 * r * r * (1.0 + f), f * f * f) /
         6.0;
}

/// Likewise of its derivative.
vec4 lichenCubicSlopes(float f) {
  float r = 1.0 - f;
  return 0.5 * vec4(-r * r, f * (3.0 * f - 4.0), r * (4.0 - 3.0 * r), f * f);
}

/// Value and derivatives [1 / texel] of the cubic B-spline of the first channel's coefficients.
vec3 lichenTextonCubicGradient(LICHEN_IMAGE_2D image, vec2 texel, float frame, LichenNoise noise) {
  vec2 base = floor(texel - 0.5);
  vec2 f = texel - 0.5 - base;
  // The image repeats: texels that hold no coefficients do not count.
  vec4 columns = base.x + vec4(-1.0, 0.0, 1.0, 2.0);
  vec4 rows = base.y + vec4(-1.0, 0.0, 1.0, 2.0);
  vec2 coefficients = lichenTextonCoefficients(noise);
  vec4 isColumn = step(vec4(0.0), columns) * step(columns, vec4(coefficients.x - 1.0));
  vec4 isRow = step(vec4(0.0), rows) * step(rows, vec4(coefficients.y - 1.0));
  vec4 weightX = lichenCubicWeights(f.x) * isColumn;
  vec4 weightY = lichenCubicWeights(f.y) * isRow;
  vec4 slopeX = lichenCubicSlopes(f.x) * isColumn;
  vec4 slopeY = lichenCubicSlopes(f.y) * isRow;
  vec2 size = lichenTextonImageSize(noise);
  vec2 corner = base + vec2(0.0, frame); // between the first two texels along each axis
  vec4 aboveLeft = LICHEN_GATHER_2D(image, corner / size);
  vec4 aboveRight = LICHEN_GATHER_2D(image, (corner + vec2(2.0, 0.0)) / size);
  vec4 belowLeft = LICHEN_GATHER_2D(image, (corner + vec2(0.0, 2.0)) / size);
  vec4 belowRight = LICHEN_GATHER_2D(image, (corner + 2.0) / size);
  // A gather's components: lower left, lower right, upper right, upper left, y downwards.
  mat4 texels = mat4(aboveLeft.wz, aboveRight.wz, aboveLeft.xy, aboveRight.xy, belowLeft.wz,
                     belowRight.wz, belowLeft.xy, belowRight.xy);
  vec4 values = weightX * texels; // of each row
  return vec3(dot(values, weightY), dot(slopeX * texels, weightY), dot(values, slopeY));
}

// What differences reach beyond a texton, in texels of the level.
#define LICHEN_GRADIENT_MARGIN 0.5

/// Value and derivatives [1 / texel] at `texel` of an impact's frame, filtered to the footprint.
vec3 lichenTextonGradientAt(LICHEN_IMAGE_2D image, vec2 texel, LichenImpacts impacts,
                            LichenNoise noise) {
  float frame = lichenTextonFrame(texel, impacts, noise);
  float minified = lichenMinified(impacts);
  bool isCubic =
      bool(LICHEN_CUBIC_TEXTONS) && lichenTextonNoise(noise).order == 3u && minified < 1.0;
  float side = exp2(isCubic ? ceil(minified) : impacts.level);
  // Where the image repeats, the next copy does not count.
  vec2 reach = impacts.radius - LICHEN_GRADIENT_MARGIN * exp2(impacts.level);
  vec2 low = impacts.middle - reach;
  vec2 high = impacts.middle + reach;
  LichenImpacts mip = impacts;
  if (isCubic) {
    lichenMipReach(ceil(minified), lichenTextonCoefficients(noise), low, high);
    lichenSetSquare(mip, side);
  }
  // The value of order 0 has steps; its differences are those between them.
  vec2 valueTexel = texel;
  if (bool(LICHEN_NEAREST_TEXTONS) && lichenTextonNoise(noise).order == 0u)
    valueTexel = mix(floor(texel) + 0.5, texel, minified);
  vec2 top = vec2(0.0, frame);
  vec2 alongX = vec2(0.5 * side, 0.0);
  vec2 alongY = alongX.yx;
  vec2 left = clamp(texel - alongX, low, high) + top;
  vec2 right = clamp(texel + alongX, low, high) + top;
  vec2 above = clamp(texel - alongY, low, high) + top;
  vec2 below = clamp(texel + alongY, low, high) + top;
  vec3 differences;
  differences.x = lichenTextonFiltered(image, clamp(valueTexel, low, high) + top, mip, noise).x;
  differences.y = (lichenTextonFiltered(image, right, mip, noise).x -
                   lichenTextonFiltered(image, left, mip, noise).x) /
                  side;
  differences.z = (lichenTextonFiltered(image, below, mip, noise).x -
                   lichenTextonFiltered(image, above, mip, noise).x) /
                  side;
  if (!isCubic)
    return differences;
  return mix(lichenTextonCubicGradient(image, texel, frame, noise), differences, minified);
}

/// Impacts for lichenTextonGradient, at `position` [tiles] of a pixel with these gradients.
LichenImpacts lichenGradientImpactsAt(vec2 position, vec2 gradientX, vec2 gradientY,
                                      LichenMaterial material, LichenNoise noise) {
  return lichenImpactsWithin(LICHEN_GRADIENT_MARGIN, position, gradientX, gradientY, material,
                             noise);
}

/// The stored value of a map's first channel, not clamped, and its derivatives along x and y
/// [1 / tile]. `table` is that of the map's binding, fetched of mixes only.
vec3 lichenTextonGradient(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenImpacts impacts,
                          LichenMaterial material, LichenNoise noise, LichenMap map) {
  LichenMap here = lichenMixedMap(table, impacts, noise, map);
  float gain = lichenTextonGain(lichenTextonRetained(table, impacts, noise, map), material).x;
  vec3 sum = vec3(0.0);
  LichenWalk walk = lichenFirstImpact(impacts, material);
  while (gain > 0.0 && lichenHasImpact(walk, impacts)) {
    lichenStep(walk, impacts, material, noise);
    if (walk.isReached)
      sum +=
          walk.sign * lichenTextonGradientAt(image, walk.offset + impacts.middle, impacts, noise);
  }
  vec3 gradient = here.row0.x * here.sumFactor.x * lichenTextonMaterial(material).amplitude * gain *
                  sum * vec3(1.0, noise.tileTexelsX, noise.tileTexelsY);
  return gradient + vec3(here.row0.w, lichenMixMeanSlope(table, impacts, noise));
}

#endif
