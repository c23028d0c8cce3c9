// SPDX-License-Identifier: MIT
// Local random-phase noise [LRP14], from top to bottom: a point on the plane of tiles and its
// footprint -> for each octave the three vertices around it and their windows -> the sum of the
// cosines of each, and of the structure, with the share of the variance that the footprint loses.
// decode.glsl makes the material's value of it.
// [LRP14] Gilet et al. 2014. Deviations, with reasons: docs/decisions/009-local-random-phase.md.

/// Adds one cosine at three vertices: to the sum of Gaussian values, to the sum of the squared
/// amplitudes of all channels under the windows, and in w to what the footprint takes of it.
/// `box`: the cosine's half of a texel of column 0, the others the variants of the vertices.
/// Advances the vertices' random numbers. `isFiltered`: whether the footprint exceeds a texel.
void lichenAddCosine(LICHEN_INOUT(vec4) sum, LICHEN_INOUT(float) squares,
                     LICHEN_INOUT(uvec3) states, LichenCosinesVertices vertices, vec3 footprint,
                     bool isFiltered, vec2 box, vec2 variant0, vec2 variant1, vec2 variant2) {
  vec2 middle = lichenBfloat16Pair(box.x), size = lichenBfloat16Pair(box.y);
  vec4 amplitude0 = vec4(lichenBfloat16Pair(variant0.x), lichenBfloat16Pair(variant0.y));
  vec4 amplitude1 = vec4(lichenBfloat16Pair(variant1.x), lichenBfloat16Pair(variant1.y));
  vec4 amplitude2 = vec4(lichenBfloat16Pair(variant2.x), lichenBfloat16Pair(variant2.y));
  // The generator of pcg without its output function; the phase has the high bits.
  states = states * 747796405u + 2891336453u;
  const float kPerBit = 1.0 / 4294967296.0; // of signed integers: -1/2 to 1/2
  vec3 frequencyX = middle.x + size.x * kPerBit * vec3(ivec3(states << 21u));
  vec3 frequencyY = middle.y + size.y * kPerBit * vec3(ivec3(states << 11u));
  vec3 turns = frequencyX * vertices.offsetX + frequencyY * vertices.offsetY +
               kPerBit * vec3(ivec3(states)) + vec3(amplitude0.a, amplitude1.a, amplitude2.a);
  vec3 own = vec3(dot(amplitude0.rgb, amplitude0.rgb), dot(amplitude1.rgb, amplitude1.rgb),
                  dot(amplitude2.rgb, amplitude2.rgb));
  vec3 windows = vertices.windows;
  squares += dot(windows * windows, own);
  if (isFiltered) {
    vec3 cycles = dot(footprint.xy, vertices.spread) +
                  frequencyX * (footprint.x * frequencyX + footprint.z * frequencyY) +
                  footprint.y * frequencyY * frequencyY;
    windows *= lichenCosineRetained(vec4(cycles, 0.0)).xyz;
    sum.w += dot(vertices.windows * vertices.windows - windows * windows, own);
  }
  vec3 values = windows * lichenCosineOfTurns(vec4(turns, 0.0)).xyz;
  sum +=
      vec4(values.x * amplitude0.rgb + values.y * amplitude1.rgb + values.z * amplitude2.rgb, 0.0);
}

/// The Gaussian value; the loss is averaged over the channels.
LichenGaussian lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
                                LichenCosinesPoint point, LichenMaterial material,
                                LichenNoise noise, LichenMap map) {
  LichenCosinesNoise shape = lichenCosinesNoise(noise);
  vec3 footprint = lichenWaveFootprint(point.gradientX, point.gradientY,
                                       vec2(noise.tileTexelsX, noise.tileTexelsY));
  bool isFiltered = footprint != vec3(0.0);
  vec4 sum = vec4(0.0);
  float squares = 0.0;
  int row = 0;
  int rows = int(shape.cosines) / 2;
  for (int octave = 0; octave < LICHEN_MAX_OCTAVES && row < rows; ++octave) {
    int end = row + lichenOctaveCosines(octave, shape) / 2;
    LichenCosinesVertices vertices = lichenCosinesVertices(point, octave, uint(octave), material);
    uvec3 states = vertices.states;
    ivec3 variants = 1 + ivec3((states >> 27u) & (shape.variants - 1u));
    for (; row < end; ++row) {
      vec4 boxes = LICHEN_FETCH_2D(image, ivec2(0, row));
      vec4 variant0 = LICHEN_FETCH_2D(image, ivec2(variants.x, row));
      vec4 variant1 = LICHEN_FETCH_2D(image, ivec2(variants.y, row));
      vec4 variant2 = LICHEN_FETCH_2D(image, ivec2(variants.z, row));
      lichenAddCosine(sum, squares, states, vertices, footprint, isFiltered, boxes.xy, variant0.xy,
                      variant1.xy, variant2.xy);
      lichenAddCosine(sum, squares, states, vertices, footprint, isFiltered, boxes.zw, variant0.zw,
                      variant1.zw, variant2.zw);
    }
  }
  lichenAddStructure(sum, squares, image, point, material, noise, map);
  const float kLeast = 1.0e-20; // of a map that does not vary
  return LichenGaussian(0.5 + material.contrast * sum.rgb, vec3(sum.w / max(squares, kLeast)), 0.0);
}

void lichenSetPoint(LICHEN_OUT(LichenCosinesPoint) point, vec2 position, vec2 gradientX,
                    vec2 gradientY, LichenMaterial material, LichenNoise noise) {
  vec2 skewed = lichenSkewed(position, material);
  vec2 cell = floor(skewed);
  ivec2 vertex = ivec2(cell);
  if (lichenIsPeriodic(material))
    lichenWholePeriods(vertex, material);
  point.cell = ivec3(vertex, 0);
  point.inside = vec3(skewed - cell, 0.0);
  point.position = fract(position);
  point.origin = uvec2(ivec2(material.cellI, material.cellJ));
  point.seedWord = material.seedWord;
  point.gradientX = gradientX;
  point.gradientY = gradientY;
}
