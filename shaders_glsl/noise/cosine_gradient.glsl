// SPDX-License-Identifier: MIT
// A local random-phase map's first channel and its derivatives, for bumps of a height: a point and
// its footprint -> (value, d/dx, d/dy), per tile. Derivatives of cosines and windows are exact;
// those of a structure are differences.
#ifndef LICHEN_COSINE_GRADIENT_GLSL
#define LICHEN_COSINE_GRADIENT_GLSL

#include "decoded_gradient.glsl"
#include "local_random_phase.glsl"

/// Derivatives of the three normalised windows along x and y [1 / tile].
void lichenCosineWindowSlopes(LichenCosinesVertices vertices, vec2 cellsPerTile,
                              LICHEN_OUT(vec3) alongX, LICHEN_OUT(vec3) alongY) {
  vec3 rows = vertices.offsetY * cellsPerTile.y;
  vec3 columns = vertices.offsetX * cellsPerTile.x - 0.5 * rows;
  const float kPerSquaredRadius = 4.0 / 3.0; // as lichenCosineWindows
  vec3 squares = columns * columns + columns * rows + rows * rows;
  vec3 left = max(1.0 - kPerSquaredRadius * squares, 0.0);
  vec3 windows = left * left * left;
  float perLength = inversesqrt(dot(windows, windows));
  vec3 slopes = -3.0 * kPerSquaredRadius * perLength * left * left; // per squared distance
  vec3 alongColumns = slopes * (2.0 * columns + rows);
  vec3 alongRows = slopes * (columns + 2.0 * rows);
  alongX = cellsPerTile.x * alongColumns;
  alongY = cellsPerTile.y * (alongRows - 0.5 * alongColumns);
  // The squares of the windows sum to 1 everywhere.
  alongX -= vertices.windows * dot(vertices.windows, alongX);
  alongY -= vertices.windows * dot(vertices.windows, alongY);
}

/// Adds one cosine at three vertices: to the sums of each before its window, and to the derivatives
/// with constant windows. Other arguments as lichenAddCosine has them.
void lichenAddCosineSlopes(LICHEN_INOUT(mat3) sums, LICHEN_INOUT(LichenGaussianSlopes) slopes,
                           LICHEN_INOUT(uvec3) states, LichenCosinesVertices vertices,
                           vec3 footprint, vec2 box, vec2 variant0, vec2 variant1, vec2 variant2) {
  vec2 middle = lichenBfloat16Pair(box.x), size = lichenBfloat16Pair(box.y);
  vec4 amplitude0 = vec4(lichenBfloat16Pair(variant0.x), lichenBfloat16Pair(variant0.y));
  vec4 amplitude1 = vec4(lichenBfloat16Pair(variant1.x), lichenBfloat16Pair(variant1.y));
  vec4 amplitude2 = vec4(lichenBfloat16Pair(variant2.x), lichenBfloat16Pair(variant2.y));
  states = states * 747796405u + 2891336453u;
  const float kPerBit = 1.0 / 4294967296.0;
  vec3 frequencyX = middle.x + size.x * kPerBit * vec3(ivec3(states << 21u));
  vec3 frequencyY = middle.y + size.y * kPerBit * vec3(ivec3(states << 11u));
  vec3 turns = frequencyX * vertices.offsetX + frequencyY * vertices.offsetY +
               kPerBit * vec3(ivec3(states)) + vec3(amplitude0.a, amplitude1.a, amplitude2.a);
  vec3 cycles = dot(footprint.xy, vertices.spread) +
                frequencyX * (footprint.x * frequencyX + footprint.z * frequencyY) +
                footprint.y * frequencyY * frequencyY;
  vec3 retained = lichenCosineRetained(vec4(cycles, 0.0)).xyz;
  vec3 values = retained * lichenCosineOfTurns(vec4(turns, 0.0)).xyz;
  const float kRadians = 6.28318531;
  vec3 sines =
      kRadians * vertices.windows * retained * lichenCosineOfTurns(vec4(turns + 0.25, 0.0)).xyz;
  vec3 alongX = frequencyX * sines, alongY = frequencyY * sines;
  sums[0] += values.x * amplitude0.rgb;
  sums[1] += values.y * amplitude1.rgb;
  sums[2] += values.z * amplitude2.rgb;
  mat3 amplitudes = mat3(amplitude0.rgb, amplitude1.rgb, amplitude2.rgb);
  slopes.alongX += amplitudes * alongX;
  slopes.alongY += amplitudes * alongY;
}

/// Derivatives of the cosines' sum.
LichenGaussianSlopes lichenCosinesSlopes(LICHEN_IMAGE_2D image, LichenCosinesPoint point,
                                         LichenMaterial material, LichenNoise noise) {
  LichenCosinesNoise shape = lichenCosinesNoise(noise);
  vec3 footprint = lichenWaveFootprint(point.gradientX, point.gradientY,
                                       vec2(noise.tileTexelsX, noise.tileTexelsY));
  LichenGaussianSlopes slopes = LichenGaussianSlopes(vec3(0.0), vec3(0.0));
  int row = 0;
  int rows = int(shape.cosines) / 2;
  for (int octave = 0; octave < LICHEN_MAX_OCTAVES && row < rows; ++octave) {
    int end = row + lichenOctaveCosines(octave, shape) / 2;
    LichenCosinesVertices vertices = lichenCosinesVertices(point, octave, uint(octave), material);
    uvec3 states = vertices.states;
    ivec3 variants = 1 + ivec3((states >> 27u) & (shape.variants - 1u));
    mat3 sums = mat3(0.0);
    for (; row < end; ++row) {
      vec4 boxes = LICHEN_FETCH_2D(image, ivec2(0, row));
      vec4 variant0 = LICHEN_FETCH_2D(image, ivec2(variants.x, row));
      vec4 variant1 = LICHEN_FETCH_2D(image, ivec2(variants.y, row));
      vec4 variant2 = LICHEN_FETCH_2D(image, ivec2(variants.z, row));
      lichenAddCosineSlopes(sums, slopes, states, vertices, footprint, boxes.xy, variant0.xy,
                            variant1.xy, variant2.xy);
      lichenAddCosineSlopes(sums, slopes, states, vertices, footprint, boxes.zw, variant0.zw,
                            variant1.zw, variant2.zw);
    }
    vec3 alongX, alongY;
    lichenCosineWindowSlopes(vertices, lichenCellsPerTile(octave, material), alongX, alongY);
    slopes.alongX += sums * alongX;
    slopes.alongY += sums * alongY;
  }
  return slopes;
}

/// The structure alone at an offset [tiles] from a position [tiles].
vec3 lichenStructureBeside(LICHEN_IMAGE_2D image, vec2 position, vec2 offset,
                           LichenCosinesPoint point, LichenMaterial material, LichenNoise noise,
                           LichenMap map) {
  LichenCosinesPoint beside;
  lichenSetPoint(beside, position + offset, point.gradientX, point.gradientY, material, noise);
  vec4 sum = vec4(0.0);
  float squares = 0.0;
  lichenAddStructure(sum, squares, image, beside, material, noise, map);
  return sum.rgb;
}

/// The value of a map's first channel and its derivatives along x and y of tile space [1 / tile].
/// `position` is in tiles, the gradients of the pixel are in tiles / pixel; the mapping is uv.
vec3 lichenCosinesGradient(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, vec2 position,
                           vec2 gradientX, vec2 gradientY, LichenMaterial material,
                           LichenNoise noise, LichenMap map) {
  LichenCosinesPoint point;
  lichenSetPoint(point, position, gradientX, gradientY, material, noise);
  vec4 gaussian = lichenCosinesGaussian(image, point, material, noise, map);
  LichenGaussianSlopes slopes = lichenCosinesSlopes(image, point, material, noise);
  uint structureWord = lichenCosinesNoise(noise).structure;
  if (bool(LICHEN_STRUCTURE) && structureWord != 0u) {
    vec2 step = 0.25 / vec2(lichenStructureImage(lichenCosinesNoise(noise)).size);
    vec2 alongX = vec2(step.x, 0.0), alongY = vec2(0.0, step.y);
    vec3 left = lichenStructureBeside(image, position, -alongX, point, material, noise, map);
    vec3 right = lichenStructureBeside(image, position, alongX, point, material, noise, map);
    vec3 above = lichenStructureBeside(image, position, -alongY, point, material, noise, map);
    vec3 below = lichenStructureBeside(image, position, alongY, point, material, noise, map);
    slopes.alongX += (right - left) / (2.0 * step.x);
    slopes.alongY += (below - above) / (2.0 * step.y);
  }
  return lichenDecodedGradient(table, gaussian, slopes, material.contrast, map);
}

#endif
