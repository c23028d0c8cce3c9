// SPDX-License-Identifier: MIT
// The pattern that multiple-kernels noise perturbs: a sum of cosines that repeats with the tile, in
// the rows below the kernels. A point and its footprint -> Gaussian values. [MKN12] section 5.

/// The sum of the cosines.
struct LichenPattern {
  vec3 gaussian; // less its mean
  float squares, lost; // the variance of all channels, and what the footprint takes of it
};

/// The pattern at `position` [tiles], from any whole number of tiles or from the period's begin.
/// `footprint` as lichenWaveFootprint has it.
LichenPattern lichenPatternAt(LICHEN_IMAGE_2D image, vec2 position, vec3 footprint,
                              LichenMaterial material, LichenKernelsNoise kernels) {
  LichenPattern pattern = LichenPattern(vec3(0.0), 0.0, 0.0);
  // A period holds the pattern a whole number of times.
  vec2 repeats = vec2(1.0);
  vec2 place = fract(position);
  if (lichenIsPeriodic(material)) {
    vec2 tiles = vec2(material.periodTilesX, material.periodTilesY);
    repeats = max(floor(tiles + 0.5), 1.0) / tiles;
    place = position;
  }
  const int kOfRow = 3;
  for (int k = 0; k < int(kernels.cosines); ++k) {
    ivec2 texel = ivec2(2 * (k % kOfRow), int(kernels.kernels) + k / kOfRow);
    vec4 first = LICHEN_FETCH_2D(image, texel);
    vec4 second = LICHEN_FETCH_2D(image, texel + ivec2(1, 0));
    vec2 frequency = repeats * first.xy;
    vec3 cosines = vec3(first.z, second.xz), sines = vec3(first.w, second.yw);
    float turns = dot(frequency, place);
    vec2 wave = lichenCosineOfTurns(vec4(turns, turns - 0.25, 0.0, 0.0)).xy;
    float cycles = frequency.x * (footprint.x * frequency.x + footprint.z * frequency.y) +
                   footprint.y * frequency.y * frequency.y;
    float retained = lichenCosineRetained(vec4(cycles)).x;
    float own = 0.5 * (dot(cosines, cosines) + dot(sines, sines));
    pattern.gaussian += retained * (wave.x * cosines + wave.y * sines);
    pattern.squares += own;
    pattern.lost += own * (1.0 - retained * retained);
  }
  return pattern;
}
