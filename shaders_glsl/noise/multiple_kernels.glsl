// SPDX-License-Identifier: MIT
// Multiple-kernels noise [MKN12], from top to bottom: a point on the plane of tiles and its
// footprint -> for each kernel the cells of its grid in reach -> the sum of the kernel over their
// impacts, with the share of the variance that the footprint loses. decode.glsl makes the
// material's value of it. The CPU twin is analysis/multiple_kernels/evaluate.
// [MKN12] Gilet, Dischler and Ghazanfarpour 2012. Deviations, with reasons:
// docs/decisions/031-kernels.md.
#ifndef LICHEN_MULTIPLE_KERNELS_GLSL
#define LICHEN_MULTIPLE_KERNELS_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "decode.glsl"
#include "hash.glsl"
#include "method_parts.glsl"
#include "periodic_lattice.glsl"
#include "wave.glsl"

/// What all maps of a noise share at one point.
struct LichenKernelsPoint {
  ivec2 group; // of LICHEN_KERNEL_TILES tiles that holds the point; without a period modulo 2^32
  vec2 inside; // the place in it, or in the period, [0, 1)
  uint seedWord;             // of the plane
  vec2 gradientX, gradientY; // [tiles / pixel]
};

/// A kernel and the cells of its grid that may reach a point. Offsets are in cells.
struct LichenKernel {
  vec2 frequency;  // [cycles / cell]; of a ring, (radius, 0) in cycles per tile
  mat2 toWindow;   // from an offset in cells to the window's coordinates
  vec2 perCell;    // [tiles] sides of a cell
  bool isRing;
  uvec2 corner;    // the cell that holds the point; its place in that:
  vec2 place;      // [0, 1)
  ivec2 period;    // [cells]; 0 without one
  float amplitude;
  float spread; // [cycles^2] mean square frequency of the window along each of its axes
};

/// The kernel in row `row` of an image.
LichenKernel lichenKernelAt(LICHEN_IMAGE_2D image, int row, LichenKernelsPoint point,
                            LichenMaterial material, LichenKernelsNoise kernels) {
  vec4 grid = LICHEN_FETCH_2D(image, ivec2(0, row));
  vec4 window = LICHEN_FETCH_2D(image, ivec2(1, row));
  vec4 scales = LICHEN_FETCH_2D(image, ivec2(2, row));
  LichenKernel kernel;
  kernel.amplitude = scales.x;
  kernel.spread = scales.y;
  vec2 cells = grid.zw; // in a group, or in the period
  vec2 perTile = cells / float(LICHEN_KERNEL_TILES);
  kernel.period = ivec2(0);
  bool isPeriodic = bool(LICHEN_PERIODIC_LATTICE) && material.periodRows != 0;
  if (isPeriodic) {
    vec2 tiles = vec2(material.periodTilesX, material.periodTilesY);
    cells = max(floor(perTile * tiles + 0.5), 1.0);
    kernel.period = ivec2(cells);
    vec2 fitted = cells / tiles;
    // As many impacts as the period's cells have.
    kernel.amplitude *= sqrt((perTile.x * perTile.y) / (fitted.x * fitted.y));
    perTile = fitted;
  }
  vec2 position = point.inside * cells;
  vec2 corner = floor(position);
  kernel.place = position - corner;
  kernel.corner = uvec2(ivec2(corner));
  if (!isPeriodic) // a place of almost 1 may round to it, which is the next group's corner
    kernel.corner += uvec2(point.group) * uvec2(ivec2(cells));
  kernel.perCell = 1.0 / perTile;
  kernel.isRing = row >= int(kernels.kernels - kernels.rings);
  kernel.frequency = kernel.isRing ? grid.xy : grid.xy * kernel.perCell;
  kernel.toWindow = mat2(window.xz * kernel.perCell.x, window.yw * kernel.perCell.y);
  return kernel;
}

/// sin(pi z t) / (pi z t) with z = 2 zeros from the middle to the end.
float lichenKernelSinc(float t) {
  // By the sine, which is a cosine a quarter of a turn later.
  float quarter = lichenCosineOfTurns(vec4(t - 0.25)).x;
  const float kPerTurn = 0.159154943; // 1 / (2 pi)
  const float kLeast = 1.0e-3; // where the quotient is the polynomial's slope there
  return abs(t) < kLeast ? 1.0 : quarter * kPerTurn / t;
}

/// The window at a place in its coordinates, 0 outside the support.
float lichenKernelWindow(vec2 place, uint window) {
  if (window == uint(LICHEN_WINDOW_GABOR)) {
    float left = max(1.0 - dot(place, place), 0.0);
    return left * left * left;
  }
  vec2 left = max(1.0 - place * place, 0.0);
  float taper = left.x * left.y;
  float product = taper > 0.0 ? lichenKernelSinc(place.x) * lichenKernelSinc(place.y) : 0.0;
  return window == uint(LICHEN_WINDOW_SINC) ? product : product * taper * taper;
}

/// One impact's share of each of the four sums, each a wave of another phase: plus or minus its
/// cosine, plus or minus its sine. `word`: its random numbers; `offset` from it to the point.
vec4 lichenKernelImpact(uint word, vec2 offset, LichenKernel kernel, uint window) {
  float value = lichenKernelWindow(kernel.toWindow * offset, window);
  float turns;
  if (kernel.isRing) {
    const float kPerBit = 1.0 / 4294967296.0;
    float direction = float(lichenPcg(word)) * kPerBit;
    vec2 axis = lichenCosineOfTurns(vec4(direction, direction - 0.25, 0.0, 0.0)).xy;
    turns = kernel.frequency.x * dot(axis, offset * kernel.perCell);
  } else {
    turns = dot(kernel.frequency, offset);
  }
  vec2 wave = value * lichenCosineOfTurns(vec4(turns, turns - 0.25, 0.0, 0.0)).xy;
  uvec4 signs = uvec4(word) << uvec4(31u, 30u, 29u, 28u);
  uvec4 others = uvec4(word) << uvec4(27u, 26u, 25u, 24u);
  return uintBitsToFloat(floatBitsToUint(wave.xxxx) ^ (signs & 0x80000000u)) +
         uintBitsToFloat(floatBitsToUint(wave.yyyy) ^ (others & 0x80000000u));
}

/// Where an impact lies in its cell, [0, 1).
vec2 lichenKernelPlace(uint word) {
  // 11 bits along each axis, and the middle of what they tell apart.
  const float kStep = 1.0 / 2048.0;
  return (vec2(ivec2(uvec2(word >> 21u, word >> 10u) & 2047u)) + 0.5) * kStep;
}

/// The sums over the impacts of a kernel that reach the point.
vec4 lichenKernelSums(LichenKernel kernel, uint seed, uint window) {
  // The offsets that the window reaches: |Q d| < 1 of a disk. In a row of cells at least as far as
  // `near` along y, the chord of the ellipse; of a square, all of it.
  mat2 q = kernel.toWindow;
  float xx = dot(q[0], q[0]), xy = dot(q[0], q[1]), yy = dot(q[1], q[1]);
  float determinant = xx * yy - xy * xy;
  bool isDisk = window == uint(LICHEN_WINDOW_GABOR);
  float reachY = isDisk ? sqrt(xx / determinant) : 1.0 / abs(q[1].y);
  float shear = isDisk ? xy / xx : 0.0;
  vec4 sums = vec4(0.0);
  int last = int(floor(kernel.place.y + reachY));
  for (int j = int(floor(kernel.place.y - reachY)); j <= last; ++j) {
    // Offsets along y.
    float low = kernel.place.y - float(j) - 1.0, high = kernel.place.y - float(j);
    float near = clamp(0.0, low, high);
    float chord = sqrt(max(1.0 - (isDisk ? near * near * determinant / xx : 0.0), 0.0) / xx);
    // Its middle, at both ends of the row.
    float middleLow = -shear * low, middleHigh = -shear * high;
    int end = int(floor(kernel.place.x - min(middleLow, middleHigh) + chord));
    uint row = kernel.corner.y + uint(j);
    if (kernel.period.y != 0)
      row = uint(int(row) - lichenFloorDivide(int(row), kernel.period.y) * kernel.period.y);
    for (int i = int(floor(kernel.place.x - max(middleLow, middleHigh) - chord)); i <= end; ++i) {
      uint column = kernel.corner.x + uint(i);
      if (kernel.period.x != 0)
        column =
            uint(int(column) - lichenFloorDivide(int(column), kernel.period.x) * kernel.period.x);
      uint word = lichenVertexHash(column, row, seed);
      vec2 offset = kernel.place - vec2(float(i), float(j)) - lichenKernelPlace(word);
      sums += lichenKernelImpact(word, offset, kernel, window);
    }
  }
  return kernel.amplitude * sums;
}

/// The Gaussian value, and in w the share of its variance that the footprint loses, averaged over
/// the channels.
vec4 lichenKernelsGaussian(LICHEN_IMAGE_2D image, LichenKernelsPoint point, LichenMaterial material,
                           LichenNoise noise) {
  LichenKernelsNoise kernels = lichenKernelsNoise(noise);
  vec3 footprint = lichenWaveFootprint(point.gradientX, point.gradientY,
                                       vec2(noise.tileTexelsX, noise.tileTexelsY));
  vec3 sum = vec3(0.0);
  float squares = 0.0, lost = 0.0;
  for (int row = 0; row < int(kernels.kernels); ++row) {
    vec4 color0 = LICHEN_FETCH_2D(image, ivec2(3, row));
    vec4 color1 = LICHEN_FETCH_2D(image, ivec2(4, row));
    vec4 color2 = LICHEN_FETCH_2D(image, ivec2(5, row));
    LichenKernel kernel = lichenKernelAt(image, row, point, material, kernels);
    // In tiles.
    mat2 q = mat2(kernel.toWindow[0] / kernel.perCell.x, kernel.toWindow[1] / kernel.perCell.y);
    vec2 f = kernel.isRing ? kernel.frequency : kernel.frequency / kernel.perCell;
    // A ring has all directions, and half of its square along each axis.
    float cycles = kernel.isRing
                       ? 0.5 * f.x * f.x * (footprint.x + footprint.y)
                       : f.x * (footprint.x * f.x + footprint.z * f.y) + footprint.y * f.y * f.y;
    cycles += kernel.spread *
              (footprint.x * dot(q[0], q[0]) + footprint.y * dot(q[1], q[1]) +
               footprint.z * dot(q[0], q[1]));
    float retained = lichenCosineRetained(vec4(cycles)).x;
    float own = dot(color0, color0) + dot(color1, color1) + dot(color2, color2);
    squares += own;
    lost += own * (1.0 - retained * retained);
    if (retained > 0.0) {
      vec4 sums = lichenKernelSums(kernel, lichenPcg(point.seedWord + uint(row)), kernels.window);
      sum += retained * vec3(dot(color0, sums), dot(color1, sums), dot(color2, sums));
    }
  }
  const float kLeast = 1.0e-20; // of a map that does not vary
  return vec4(0.5 + material.contrast * sum, lost / max(squares, kLeast));
}

// The seam's functions; see method.glsl.

void lichenSetPoint(out LichenKernelsPoint point, vec2 position, vec2 gradientX, vec2 gradientY,
                    LichenMaterial material, LichenNoise noise) {
  bool isPeriodic = bool(LICHEN_PERIODIC_LATTICE) && material.periodRows != 0;
  vec2 tiles = isPeriodic ? vec2(material.periodTilesX, material.periodTilesY)
                          : vec2(float(LICHEN_KERNEL_TILES));
  vec2 place = position / tiles;
  vec2 group = floor(place);
  point.inside = place - group;
  point.group = ivec2(group) + ivec2(material.cellI, material.cellJ);
  point.seedWord = material.seedWord;
  point.gradientX = gradientX;
  point.gradientY = gradientY;
}

vec3 lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenKernelsPoint point,
                      LichenMaterial material, LichenNoise noise, LichenMap map, out vec3 lost) {
  vec4 gaussian = lichenKernelsGaussian(image, point, material, noise);
  lost = vec3(gaussian.w);
  return gaussian.rgb;
}

vec4 lichenDecodedAt(LICHEN_IMAGE_3D table, vec3 gaussian, vec3 lost, LichenKernelsPoint point,
                     LichenMaterial material, LichenNoise noise, LichenMap map) {
  return lichenDecode(table, gaussian, lost.x, material.contrast, map);
}

vec4 lichenValueAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenKernelsPoint point,
                   LichenMaterial material, LichenNoise noise, LichenMap map) {
  vec4 gaussian = lichenKernelsGaussian(image, point, material, noise);
  return lichenDecode(table, gaussian.rgb, gaussian.w, material.contrast, map);
}

#endif
