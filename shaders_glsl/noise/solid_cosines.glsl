// SPDX-License-Identifier: MIT
// Local random-phase noise in a solid: a point in space and its footprint -> for each octave the
// four vertices around it and their windows -> the sum of the cosines of each, with the share of
// the variance that the footprint loses -> the material's value.
// The exemplar has a frequency (x, y); its third component is uniform up to 1.2 times the length of
// both. Planes across z then have the spectrum of the exemplar, and others nearly that, rotated
// about the direction in which the exemplar is smoothest: docs/decisions/009-local-random-phase.md.

#if LICHEN_HAS_SOLIDS
/// Sums over cosines.
struct LichenSolidSum {
  vec3 gaussian;       // less its mean
  float depthSlope;    // of slopes: that along z, stored
  float squares, lost; // squared amplitudes of all channels, and what the footprint takes of them
};

/// Adds one cosine at one vertex. `frequency` is in cycles / tile width, `value` the cosine under
/// its window.
void lichenAddSolidVertex(LICHEN_INOUT(LichenSolidSum) sum, vec3 frequency, float value,
                          float window, float retainedWindow, vec3 amplitude, LichenMap map) {
  sum.gaussian += value * amplitude;
  float own = dot(amplitude, amplitude);
  sum.squares += window * window * own;
  sum.lost += (window * window - retainedWindow * retainedWindow) * own;
  if (map.encoding != uint(LICHEN_ENCODING_SLOPE))
    return;
  // Slopes of one wave are a gradient along its frequency; y of slopes points up.
  vec2 slopes = vec2(dot(map.row0.xy, amplitude.xy), dot(map.row1.xy, amplitude.xy));
  vec2 planar = vec2(frequency.x, -frequency.y);
  const float kLeast = 1.0e-20;
  sum.depthSlope += value * frequency.z * dot(planar, slopes) / max(dot(planar, planar), kLeast);
}

/// Adds one cosine at four vertices; `box` and the amplitudes as lichenAddCosine has them. Advances
/// the vertices' random numbers.
void lichenAddSolidCosine(LICHEN_INOUT(LichenSolidSum) sum, LICHEN_INOUT(uvec4) states,
                          LICHEN_INOUT(uvec4) depths, LichenSolidVertices vertices,
                          LichenCosinesPoint point, vec2 box, vec2 variant0, vec2 variant1,
                          vec2 variant2, vec2 variant3, float aspect, LichenMap map) {
  vec2 middle = lichenBfloat16Pair(box.x), size = lichenBfloat16Pair(box.y);
  vec4 amplitude0 = vec4(lichenBfloat16Pair(variant0.x), lichenBfloat16Pair(variant0.y));
  vec4 amplitude1 = vec4(lichenBfloat16Pair(variant1.x), lichenBfloat16Pair(variant1.y));
  vec4 amplitude2 = vec4(lichenBfloat16Pair(variant2.x), lichenBfloat16Pair(variant2.y));
  vec4 amplitude3 = vec4(lichenBfloat16Pair(variant3.x), lichenBfloat16Pair(variant3.y));
  states = states * 747796405u + 2891336453u; // as lichenAddCosine draws
  const float kPerBit = 1.0 / 4294967296.0;   // of signed integers: -1/2 to 1/2
  vec4 x = middle.x + size.x * kPerBit * vec4(ivec4(states << 21u));
  vec4 y = middle.y + size.y * kPerBit * vec4(ivec4(states << 11u));
  vec4 inSpace = aspect * y; // [cycles / tile width]
  vec4 z = 2.0 * kPerBit * kLichenMostDepth * sqrt(x * x + inSpace * inSpace) * vec4(ivec4(depths));
  // By the golden ratio: third frequencies of waves of similar directions lie far apart.
  depths += 0x9E3779B9u;
  LichenSolidFootprint axes = point.footprint;
  vec4 turns = x * vertices.offsetX + y * vertices.offsetY + z * vertices.offsetZ +
               kPerBit * vec4(ivec4(states)) +
               vec4(amplitude0.a, amplitude1.a, amplitude2.a, amplitude3.a);
  vec4 alongA = x * axes.a.x + y * axes.a.y + z * axes.a.z;
  vec4 alongB = x * axes.b.x + y * axes.b.y + z * axes.b.z;
  float ofWindow = dot(vertices.spread, axes.a * axes.a + axes.b * axes.b);
  vec4 retained =
      vertices.windows * lichenCosineRetained(ofWindow + alongA * alongA + alongB * alongB);
  vec4 values = retained * lichenCosineOfTurns(turns);
  lichenAddSolidVertex(sum, vec3(x.x, inSpace.x, z.x), values.x, vertices.windows.x, retained.x,
                       amplitude0.rgb, map);
  lichenAddSolidVertex(sum, vec3(x.y, inSpace.y, z.y), values.y, vertices.windows.y, retained.y,
                       amplitude1.rgb, map);
  lichenAddSolidVertex(sum, vec3(x.z, inSpace.z, z.z), values.z, vertices.windows.z, retained.z,
                       amplitude2.rgb, map);
  lichenAddSolidVertex(sum, vec3(x.w, inSpace.w, z.w), values.w, vertices.windows.w, retained.w,
                       amplitude3.rgb, map);
}

/// The sum of all cosines.
LichenSolidSum lichenSolidSum(LICHEN_IMAGE_2D image, LichenCosinesPoint point,
                              LichenMaterial material, LichenNoise noise, LichenMap map) {
  LichenCosinesNoise shape = lichenCosinesNoise(noise);
  LichenSolidSum sum = LichenSolidSum(vec3(0.0), 0.0, 0.0, 0.0);
  int row = 0;
  int rows = int(shape.cosines) / 2;
  for (int octave = 0; octave < LICHEN_MAX_OCTAVES && row < rows; ++octave) {
    int end = row + lichenOctaveCosines(octave, shape) / 2;
    LichenSolidVertices vertices = lichenSolidVertices(point, octave, material);
    uvec4 states = vertices.states;
    uvec4 depths = states << 7u; // low bits, as the variant has the high ones
    ivec4 variants = 1 + ivec4((states >> 27u) & (shape.variants - 1u));
    for (; row < end; ++row) {
      vec4 boxes = LICHEN_FETCH_2D(image, ivec2(0, row));
      vec4 variant0 = LICHEN_FETCH_2D(image, ivec2(variants.x, row));
      vec4 variant1 = LICHEN_FETCH_2D(image, ivec2(variants.y, row));
      vec4 variant2 = LICHEN_FETCH_2D(image, ivec2(variants.z, row));
      vec4 variant3 = LICHEN_FETCH_2D(image, ivec2(variants.w, row));
      lichenAddSolidCosine(sum, states, depths, vertices, point, boxes.xy, variant0.xy, variant1.xy,
                           variant2.xy, variant3.xy, noise.tileAspect, map);
      lichenAddSolidCosine(sum, states, depths, vertices, point, boxes.zw, variant0.zw, variant1.zw,
                           variant2.zw, variant3.zw, noise.tileAspect, map);
    }
  }
  return sum;
}

void lichenSetSolidPoint(LICHEN_OUT(LichenCosinesPoint) point, vec3 position,
                         LichenSolidFootprint footprint, LichenMaterial material) {
  vec3 cubesPerTile = vec3(material.columnsPerTile, material.rowsPerTile, material.columnsPerTile);
  vec3 skewed = lichenSkewed((position + vec3(0.0, 0.0, lichenCosinesMaterial(material).offsetZ)) *
                             cubesPerTile);
  vec3 cell = floor(skewed);
  point.cell = ivec3(cell);
  point.inside = skewed - cell;
  point.footprint = footprint;
}

LichenGaussian lichenSolidGaussianAt(LICHEN_IMAGE_2D image, LichenCosinesPoint point,
                                     LichenMaterial material, LichenNoise noise, LichenMap map) {
  LichenSolidSum sum = lichenSolidSum(image, point, material, noise, map);
  const float kLeast = 1.0e-20; // of a map that does not vary
  return LichenGaussian(0.5 + material.contrast * sum.gaussian,
                        vec3(sum.lost / max(sum.squares, kLeast)),
                        material.contrast * sum.depthSlope);
}
#endif
