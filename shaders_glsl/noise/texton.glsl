// SPDX-License-Identifier: MIT
// Texton noise: impacts around a point -> the material's value.
// N(x) = mean + lambda^-1/2 sum_i e_i h(x - x_i), signs e_i, h the B-spline of the coefficients.
// [GLM17] Galerne, Leclaire and Moisan 2017, sections 3.2 and 6; [SH05] Sigg and Hadwiger 2005,
// for order 3. Deviations, with reasons: docs/decisions/008-textons.md.

/// One fetch at `texel` of the image.
vec3 lichenTextonFetch(LICHEN_IMAGE_2D image, vec2 texel, float level, LichenNoise noise) {
  // A product, whose factor is the same for all impacts: 4 % of the whole cost of a quotient.
  vec2 perTexel = 1.0 / lichenTextonImageSize(noise);
  return LICHEN_SAMPLE_2D(image, texel * perTexel, level).rgb;
}

/// The cubic B-spline of the coefficients.
vec3 lichenTextonCubic(LICHEN_IMAGE_2D image, vec2 texel, float frame, LichenNoise noise) {
  // [SH05] section 20.2: two texels of weights a and b are one bilinear fetch at b / (a + b).
  vec2 base = floor(texel - 0.5);
  vec2 f = texel - 0.5 - base;
  vec2 rest = 1.0 - f;
  vec2 weight0 = rest * rest * rest / 6.0;
  vec2 weight1 = 2.0 / 3.0 - 0.5 * f * f * (1.0 + rest);
  vec2 weight3 = f * f * f / 6.0;
  vec2 near = weight0 + weight1;
  vec2 far = 1.0 - near;
  // Half a texel outside the coefficients all is 0, as beyond, where the image repeats.
  vec2 low, high;
  lichenMipReach(0.0, lichenTextonCoefficients(noise), low, high);
  vec2 at0 = clamp(base - 0.5 + weight1 / near, low, high);
  vec2 at1 = clamp(base + 1.5 + weight3 / far, low, high);
  at0.y += frame;
  at1.y += frame;
  vec3 above = near.x * lichenTextonFetch(image, at0, 0.0, noise) +
               far.x * lichenTextonFetch(image, vec2(at1.x, at0.y), 0.0, noise);
  vec3 below = near.x * lichenTextonFetch(image, vec2(at0.x, at1.y), 0.0, noise) +
               far.x * lichenTextonFetch(image, at1, 0.0, noise);
  return near.y * above + far.y * below;
}

/// h at `texel` of its frame, filtered to the footprint.
vec3 lichenTextonAt(LICHEN_IMAGE_2D image, vec2 texel, LichenImpacts impacts, LichenNoise noise) {
  float frame = lichenTextonFrame(texel, impacts, noise);
  float minified = lichenMinified(impacts);
  // Order 0: steps where magnified, none from the first mip on.
  if (LICHEN_USES(LICHEN_FEATURE_NEAREST_TEXTONS) && lichenTextonNoise(noise).order == 0u)
    texel = mix(floor(texel) + 0.5, texel, minified);
  if (LICHEN_USES(LICHEN_FEATURE_CUBIC_TEXTONS) && lichenTextonNoise(noise).order == 3u &&
      minified < 1.0) {
    // Between the spline and the first mip.
    vec3 magnified = lichenTextonCubic(image, texel, frame, noise);
    vec2 low, high;
    float mip = ceil(minified);
    lichenMipReach(mip, lichenTextonCoefficients(noise), low, high);
    texel = clamp(texel, low, high);
    texel.y += frame;
    return mix(magnified, lichenTextonFetch(image, texel, mip, noise), minified);
  }
  texel.y += frame;
  return lichenTextonFetch(image, texel, impacts.level, noise);
}

/// The sum over impacts, with mean 0.
vec3 lichenTextonSum(LICHEN_IMAGE_2D image, LichenImpacts impacts, LichenMaterial material,
                     LichenNoise noise) {
  // [GLM17] eq. 2, symmetric signs.
  vec3 sum = vec3(0.0);
  LichenWalk walk = lichenFirstImpact(impacts, material);
  while (lichenHasImpact(walk, impacts)) {
    lichenStep(walk, impacts, material, noise);
    if (walk.isReached)
      sum += walk.sign * lichenTextonAt(image, walk.offset + impacts.middle, impacts, noise);
  }
  return sum;
}

#if LICHEN_HAS_SURFACES
/// The sum over impacts on a surface:
/// N(y) = mean + (lambda r / 3)^-1/2 sum_i e_i (1 - 2 |t_i| / r)+ h(y - x_i),
/// lambda points in a unit of space, t_i the height of point i over the tangent plane at y, in
/// which h lies. [GLM17] section 6 and proposition 3.
vec3 lichenSurfaceTextonSum(LICHEN_IMAGE_2D image, LichenImpacts impacts, LichenNoise noise) {
  vec3 sum = vec3(0.0);
  LichenSurfaceWalk walk = lichenFirstSurfaceImpact(impacts.cubes);
  while (lichenHasImpact(walk, impacts.cubes)) {
    lichenSurfaceStep(walk, impacts.cubes);
    if (walk.isReached)
      sum += walk.weight * lichenTextonAt(image, walk.offset + impacts.middle, impacts, noise);
  }
  return sum;
}
#endif

/// The share of each channel's variance that textons fetched at a level >= 0 keep: of a trilinear
/// blend of a mip and the next.
vec3 lichenTextonLevelRetained(LICHEN_IMAGE_3D table, float level, LichenImpacts impacts,
                               LichenNoise noise, LichenMap map) {
  // docs/theory.md, Filtering: the covariance of the two.
  int mip = int(level);
  vec3 fine = lichenTextonMipRetained(table, mip, impacts, noise, map);
  vec3 coarse = lichenTextonMipRetained(table, mip + 1, impacts, noise, map);
  const float kLeast = 1.0e-3; // of the amplitudes' steps of 1/255, below the first
  vec3 ratio = coarse / max(fine, kLeast);
  vec3 covariance = coarse * coarse + 0.5 * ratio * ratio * ratio * (fine * fine - coarse * coarse);
  float t = level - float(mip);
  float rest = 1.0 - t;
  return rest * rest * fine * fine + 2.0 * t * rest * covariance + t * t * coarse * coarse;
}

/// The shares of each channel's variance that filtering leaves at a point.
struct LichenRetained {
  vec3 fetched;   // left by the mips that are fetched
  vec3 footprint; // left by averages over the footprint, which may be larger
};

LichenRetained lichenTextonRetained(LICHEN_IMAGE_3D table, LichenImpacts impacts, LichenNoise noise,
                                    LichenMap map) {
  float level = min(impacts.footprintLevel, float(LICHEN_MAX_MIPS - 1));
  return LichenRetained(lichenTextonLevelRetained(table, impacts.level, impacts, noise, map),
                        lichenTextonLevelRetained(table, level, impacts, noise, map));
}

/// The factor on a sum over impacts. Beyond the last mip textons stay the same, and the factor
/// falls as the deviation of averages does.
vec3 lichenTextonGain(LichenRetained retained, LichenMaterial material) {
  const float kLeast = 1.0e-6; // below the square of an amplitude's first step, 1/255
  return material.contrast * sqrt(retained.footprint / max(retained.fetched, kLeast));
}

/// The Gaussian value for a sum over impacts, which is not needed where the gain is 0.
LichenGaussian lichenOfTextons(vec3 sum, vec3 gain, LichenRetained retained,
                               LichenMaterial material, LichenMap map) {
  vec3 factor = lichenTextonMaterial(material).amplitude * gain * map.sumFactor.rgb;
  return LichenGaussian(0.5 + factor * sum, 1.0 - retained.footprint, 0.0);
}

LichenGaussian lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenImpacts impacts,
                                LichenMaterial material, LichenNoise noise, LichenMap map) {
  LichenRetained retained = lichenTextonRetained(table, impacts, noise, map);
  vec3 gain = lichenTextonGain(retained, material);
  vec3 sum = vec3(0.0);
  if (gain != vec3(0.0))
    sum = lichenTextonSum(image, impacts, material, noise);
  return lichenOfTextons(sum, gain, retained, material, map);
}

#if LICHEN_HAS_SURFACES
LichenGaussian lichenSurfaceGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
                                       LichenImpacts impacts, LichenMaterial material,
                                       LichenNoise noise, LichenMap map) {
  LichenRetained retained = lichenTextonRetained(table, impacts, noise, map);
  vec3 gain = lichenTextonGain(retained, material);
  vec3 sum = vec3(0.0);
  if (gain != vec3(0.0))
    sum = lichenSurfaceTextonSum(image, impacts, noise);
  return lichenOfTextons(sum, gain, retained, material, map);
}
#endif
