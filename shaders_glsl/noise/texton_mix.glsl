// SPDX-License-Identifier: MIT
// Mixes of textons: weight of a mix -> the step of an impact, and the map's constants at a point.
// Each impact takes the texton of its own weight; mean, deviation and what mips retain are
// interpolated between the two nearest steps, from a table of them. [GLM17] Galerne, Leclaire and
// Moisan 2017, section 7.

bool lichenIsMix(LichenNoise noise) {
  return LICHEN_USES(LICHEN_FEATURE_MIXES) && lichenTextonNoise(noise).steps > 1u;
}

/// The weight of a constant or a direction, at texture coordinates.
float lichenMixWeight(vec2 uv, LichenMaterial material) {
  LichenTextonMaterial own = lichenTextonMaterial(material);
  return own.mixWeight + dot(vec2(own.mixPerU, own.mixPerV), uv);
}

/// Its derivative along x and y of tile space [1 / tile].
vec2 lichenMixGradient(LichenMaterial material) {
  LichenTextonMaterial own = lichenTextonMaterial(material);
  // The transposed inverse of a rotation with a scale is itself over the scale's square.
  vec2 row = vec2(material.uvToTileXX, material.uvToTileXY);
  return lichenUvToTile(vec2(own.mixPerU, own.mixPerV), material) / dot(row, row);
}

/// The top of an impact's frame in the image: in a mix, the frame of its own weight. [texels]
float lichenTextonFrame(vec2 texel, LichenImpacts impacts, LichenNoise noise) {
  if (!lichenIsMix(noise))
    return 0.0;
  vec2 coefficients = lichenTextonCoefficients(noise);
  vec2 tiles = (0.5 * coefficients - texel) / vec2(noise.tileTexelsX, noise.tileTexelsY);
  float weight = clamp(impacts.mixWeight + dot(impacts.mixGradient, tiles), 0.0, 1.0);
  LichenTextonNoise texton = lichenTextonNoise(noise);
  return floor(weight * (float(int(texton.steps)) - 1.0) + 0.5) * float(texton.frameY);
}

/// A row of a mix's table at a step, [0, steps - 1], linear between whole ones.
vec4 lichenMixRow(LICHEN_IMAGE_3D table, float atStep, int row, LichenNoise noise) {
  vec3 coordinate = vec3((atStep + 0.5) / float(int(lichenTextonNoise(noise).steps)), 0.5,
                         (float(row) + 0.5) / float(LICHEN_MIX_ROWS));
  return LICHEN_SAMPLE_3D(table, coordinate, 0.0);
}

/// The step of the point itself, [0, steps - 1].
float lichenMixStep(LichenImpacts impacts, LichenNoise noise) {
  return clamp(impacts.mixWeight, 0.0, 1.0) * (float(int(lichenTextonNoise(noise).steps)) - 1.0);
}

/// The map's constants at the point's weight in a mix, except the amplitudes of mips
/// (lichenTextonMipRetained). Without a mix, `map` itself. `table`: at the map's binding.
LichenMap lichenMixedMap(LICHEN_IMAGE_3D table, LichenImpacts impacts, LichenNoise noise,
                         LichenMap map) {
  if (!lichenIsMix(noise))
    return map;
  float atStep = lichenMixStep(impacts, noise);
  vec3 mean = lichenMixRow(table, atStep, LICHEN_MIX_MEAN, noise).rgb;
  vec3 deviation = lichenMixRow(table, atStep, LICHEN_MIX_DEVIATION, noise).rgb; // above 0
  map.row0.w += mean.x;
  map.row1.w += mean.y;
  map.row2.w += mean.z;
  map.row0.x *= deviation.x;
  map.row1.y *= deviation.y;
  map.row2.z *= deviation.z;
  // Cancels the factor on the rows: the stored value does not depend on the deviation.
  map.sumFactor = vec4(1.0 / deviation, 0.0);
  return map;
}

/// The amplitudes that the texels of a mip retain of each channel, at the point's weight of a mix.
vec3 lichenTextonMipRetained(LICHEN_IMAGE_3D table, int mip, LichenImpacts impacts,
                             LichenNoise noise, LichenMap map) {
  if (!lichenIsMix(noise))
    return vec3(lichenMipRetained(mip, map.mipRetained0), lichenMipRetained(mip, map.mipRetained1),
                lichenMipRetained(mip, map.mipRetained2));
  int row = LICHEN_MIX_RETAINED + min(mip, LICHEN_MAX_MIPS - 1);
  vec3 retained = lichenMixRow(table, lichenMixStep(impacts, noise), row, noise).rgb;
  // Rounded to bytes, like the amplitudes of maps without a mix: exactly 0 in distant views.
  return floor(255.0 * retained + 0.5) * (1.0 / 255.0);
}
