// SPDX-License-Identifier: MIT
// Multiple-kernels noise [MKN12], from top to bottom: a point on the plane of tiles and its
// footprint -> for each kernel the cells of its grid in reach -> the sum of the kernel over their
// impacts, with the share of the variance that the footprint loses. decode.glsl makes the
// material's value of it.
// [MKN12] Gilet, Dischler and Ghazanfarpour 2012. Deviations, with reasons:
// docs/decisions/010-multiple-kernels.md.
#ifndef LICHEN_MULTIPLE_KERNELS_GLSL
#define LICHEN_MULTIPLE_KERNELS_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "decode.glsl"
#include "decoded_gradient.glsl"
#include "hash.glsl"
#include "kernel_pattern.glsl"
#include "method_parts.glsl"
#include "periodic_lattice.glsl"
#include "wave.glsl"

// 0 where no kernel is a ring; 0 where all have the window of the kind gabor, not one on a square;
// 0 where no noise has a pattern. Literals, or the host's specialization constants.
#ifndef LICHEN_RING_KERNELS
#define LICHEN_RING_KERNELS 1
#endif
#ifndef LICHEN_SQUARE_KERNELS
#define LICHEN_SQUARE_KERNELS 1
#endif
#ifndef LICHEN_KERNEL_PATTERN
#define LICHEN_KERNEL_PATTERN 1
#endif

/// What all maps of a noise share at one point.
struct LichenKernelsPoint {
  ivec2 group;   // of LICHEN_KERNEL_TILES tiles that holds the point; without a period modulo 2^32
  vec2 inside;   // the place in it, or in the period, [0, 1)
  uint seedWord; // of the plane
  vec2 gradientX, gradientY; // [tiles / pixel]
};

/// One row of an image.
struct LichenKernelRow {
  vec2 frequency; // [cycles / tile]; of a ring, (radius, 0)
  bool isRing;
  vec2 cells;    // columns and rows of its grid in LICHEN_KERNEL_TILES tiles
  mat2 toWindow; // Q: from an offset in tiles to the window's coordinates
  float amplitude;
  float cubes;             // on surfaces, those of its grid in LICHEN_KERNEL_TILES tile widths
  float layers, toWindowZ; // in solids, likewise; and Q along z
};

/// The row `row` of an image.
LichenKernelRow lichenKernelRow(LICHEN_IMAGE_2D image, int row, LichenKernelsNoise kernels) {
  vec4 grid = LICHEN_FETCH_2D(image, ivec2(0, row));
  vec4 window = LICHEN_FETCH_2D(image, ivec2(1, row));
  vec4 scales = LICHEN_FETCH_2D(image, ivec2(2, row));
  const float kOfWave = 1.41421356; // whose square is 1 in the mean
  bool isRing = bool(LICHEN_RING_KERNELS) && row >= int(kernels.kernels - kernels.rings);
  return LichenKernelRow(grid.xy, isRing, grid.zw, mat2(window.xz, window.yw), kOfWave * scales.x,
                         scales.y, scales.z, scales.w);
}

/// A kernel and the cells of its grid that may reach a point. Offsets are in cells.
struct LichenKernel {
  vec2 frequency; // [cycles / cell]; of a ring, (radius, 0) in cycles per tile
  bool isRing;
  mat2 toWindow; // from an offset in cells to the window's coordinates
  vec2 perCell;  // [tiles] sides of a cell
  uvec2 corner;  // the cell that holds the point; its place in that:
  vec2 place;    // [0, 1)
  ivec2 period;  // [cells]; 0 without one
  float amplitude;
};

/// The kernel of a row around a point.
LichenKernel lichenKernelAt(LichenKernelRow row, LichenKernelsPoint point,
                            LichenMaterial material) {
  LichenKernel kernel;
  kernel.amplitude = row.amplitude;
  kernel.isRing = row.isRing;
  vec2 cells = row.cells; // in a group, or in the period
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
  kernel.frequency = row.isRing ? row.frequency : row.frequency * kernel.perCell;
  kernel.toWindow = mat2(row.toWindow[0] * kernel.perCell.x, row.toWindow[1] * kernel.perCell.y);
  return kernel;
}

/// sin(pi z t) / (pi z t) with z = 2 zeros from the middle to the end.
float lichenKernelSinc(float t) {
  // By the sine, which is a cosine a quarter of a turn later.
  float quarter = lichenCosineOfTurns(vec4(t - 0.25)).x;
  const float kPerTurn = 0.159154943; // 1 / (2 pi)
  const float kLeast = 1.0e-3;        // where the quotient is the polynomial's slope there
  return abs(t) < kLeast ? 1.0 : quarter * kPerTurn / t;
}

/// Whether windows are of the kind gabor, in the unit disk.
bool lichenIsOnDisk(uint window) {
  return !bool(LICHEN_SQUARE_KERNELS) || window == uint(LICHEN_WINDOW_GABOR);
}

/// The window at a place in its coordinates, 0 outside the support.
float lichenKernelWindow(vec2 place, uint window) {
  if (lichenIsOnDisk(window)) {
    float left = max(1.0 - dot(place, place), 0.0);
    return left * left * left;
  }
  vec2 left = max(1.0 - place * place, 0.0);
  float taper = left.x * left.y;
  float product = taper > 0.0 ? lichenKernelSinc(place.x) * lichenKernelSinc(place.y) : 0.0;
  return window == uint(LICHEN_WINDOW_SINC) ? product : product * taper * taper;
}

/// The derivative of lichenKernelSinc.
float lichenKernelSincSlope(float t) {
  // Near 0 its series, where the difference of approximations would be rounded.
  const float kLeast = 0.1, kRadians = 6.28318531;
  float x = kRadians * t, square = x * x;
  float near = kRadians * x * (square * (1.0 / 30.0 - square / 840.0) - 1.0 / 3.0);
  float cosine = lichenCosineOfTurns(vec4(t)).x;
  return abs(t) < kLeast ? near : (cosine - lichenKernelSinc(t)) / t;
}

/// The derivatives of lichenKernelWindow along its coordinates.
vec2 lichenKernelWindowSlope(vec2 place, uint window) {
  if (lichenIsOnDisk(window)) {
    float left = max(1.0 - dot(place, place), 0.0);
    return -6.0 * left * left * place;
  }
  vec2 left = max(1.0 - place * place, 0.0);
  if (left.x * left.y == 0.0)
    return vec2(0.0);
  vec2 sinc = vec2(lichenKernelSinc(place.x), lichenKernelSinc(place.y));
  vec2 slope = vec2(lichenKernelSincSlope(place.x), lichenKernelSincSlope(place.y));
  if (window == uint(LICHEN_WINDOW_GAUSSIAN_SINC)) {
    slope = left * (left * slope - 4.0 * place * sinc);
    sinc *= left * left;
  }
  return slope * sinc.yx;
}

/// The phase of an impact, by a bit of its random numbers: an eighth of a turn, so that slow
/// kernels are as strong as others. [turns]
float lichenKernelPhase(uint word) { return float(int((word >> 4u) & 1u)) * 0.25 - 0.125; }

/// The wave of an impact -> its four waves, which differ in their signs, by bits of its random
/// numbers.
vec4 lichenKernelWaves(float wave, uint word) {
  uvec4 signs = (uvec4(word) << uvec4(31u, 30u, 29u, 28u)) & 0x80000000u;
  return uintBitsToFloat(uvec4(floatBitsToUint(wave)) ^ signs);
}

/// The direction of a ring's impact in a cell [2^-32 turns]. Those of neighbours are spread evenly,
/// by 2^32 over the plastic number and over its square: of few random ones some would stand out.
uint lichenRingTurns(uint column, uint row, uint seed) {
  return column * 0xC13FA9A9u + row * 0x91E10DA5u + seed;
}

vec2 lichenRingDirection(uint turns) {
  const float kPerBit = 1.0 / 4294967296.0; // of signed integers: -1/2 to 1/2
  float direction = kPerBit * float(int(turns));
  return lichenCosineOfTurns(vec4(direction, direction - 0.25, 0.0, 0.0)).xy;
}

/// Sums over impacts of their four waves, and derivatives of these along x and y [1 / cell].
struct LichenKernelSums {
  vec4 waves, alongX, alongY;
};

/// Adds one impact. `word`: its random numbers; `turns`: its direction, of a ring; `offset` from it
/// to the point. Derivatives are 0 unless `hasSlopes`, a constant.
void lichenAddKernelImpact(LICHEN_INOUT(LichenKernelSums) sums, uint word, uint turns, vec2 offset,
                           LichenKernel kernel, uint window, bool hasSlopes) {
  vec2 place = kernel.toWindow * offset;
  float value = lichenKernelWindow(place, window);
  vec2 frequency = kernel.frequency;
  if (kernel.isRing)
    frequency = kernel.frequency.x * lichenRingDirection(turns) * kernel.perCell;
  float phase = dot(frequency, offset) + lichenKernelPhase(word);
  float wave = lichenCosineOfTurns(vec4(phase)).x;
  sums.waves += lichenKernelWaves(value * wave, word);
  if (hasSlopes) {
    const float kRadians = 6.28318531;
    vec2 slope = lichenKernelWindowSlope(place, window) * kernel.toWindow * wave;
    slope += kRadians * value * lichenCosineOfTurns(vec4(phase + 0.25)).x * frequency;
    sums.alongX += lichenKernelWaves(slope.x, word);
    sums.alongY += lichenKernelWaves(slope.y, word);
  }
}

/// Where an impact lies in its cell, [0, 1).
vec2 lichenKernelPlace(uint word) {
  // 11 bits along each axis, and the middle of what they tell apart.
  const float kStep = 1.0 / 2048.0;
  return (vec2(ivec2(uvec2(word >> 21u, word >> 10u) & 2047u)) + 0.5) * kStep;
}

/// The sums over the impacts of a kernel that reach the point, times its amplitude.
LichenKernelSums lichenKernelSums(LichenKernel kernel, uint seed, uint window, bool hasSlopes) {
  // The offsets that the window reaches: |Q d| < 1 of a disk. In a row of cells at least as far as
  // `near` along y, the chord of the ellipse; of a square, all of it.
  mat2 q = kernel.toWindow;
  float xx = dot(q[0], q[0]), product = dot(q[0], q[1]), yy = dot(q[1], q[1]);
  float determinant = xx * yy - product * product;
  bool isDisk = lichenIsOnDisk(window);
  float reachY = isDisk ? sqrt(xx / determinant) : 1.0 / abs(q[1].y);
  float shear = isDisk ? product / xx : 0.0;
  LichenKernelSums sums = LichenKernelSums(vec4(0.0), vec4(0.0), vec4(0.0));
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
      lichenAddKernelImpact(sums, word, lichenRingTurns(column, row, seed), offset, kernel, window,
                            hasSlopes);
    }
  }
  sums.waves *= kernel.amplitude;
  sums.alongX *= kernel.amplitude;
  sums.alongY *= kernel.amplitude;
  return sums;
}

/// The amplitude that a pixel leaves of a kernel. `cycles`: the square of those that it spans of
/// the wave; the trace and the determinant are those of the matrix of squared cycles that it spans
/// of the window's spectrum.
float lichenKernelRetained(float cycles, float trace, float determinant) {
  // The root of the mean of exp(-|A f|^2) over a normal distribution of frequencies f about that
  // of the wave, A f the cycles that the pixel spans; exact where the window's share is alike along
  // both axes. For few cycles it is the same as lichenCosineRetained.
  const float kSlope = 6.57973627; // 2 pi^2 / 3
  float wider = sqrt(max(1.0 + kSlope * (trace + kSlope * determinant), 1.0));
  float retained = lichenCosineRetained(vec4(cycles / wider)).x * inversesqrt(wider);
  // Such a spectrum has no end; but a faint kernel that is smaller than the pixel flickers.
  const float kFaint = 0.3;
  return max((1.0 + kFaint) * retained - kFaint, 0.0);
}

/// The mean square frequency of a window along each of its axes. [cycles^2]
float lichenKernelSpread(uint window) {
  // Of the kind gabor 21 / (20 pi^2), of the others by quadrature.
  if (lichenIsOnDisk(window))
    return 0.106387243;
  return window == uint(LICHEN_WINDOW_SINC) ? 0.297779771 : 0.292652321;
}

/// The amplitude that a pixel leaves of a kernel. `footprint` as lichenWaveFootprint has it.
float lichenKernelRetained(LichenKernelRow row, vec3 footprint, uint window) {
  mat2 q = row.toWindow;
  vec2 f = row.frequency;
  float spread = lichenKernelSpread(window);
  // A ring has all directions, and half of its square along each axis.
  float cycles = row.isRing
                     ? 0.5 * f.x * f.x * (footprint.x + footprint.y)
                     : f.x * (footprint.x * f.x + footprint.z * f.y) + footprint.y * f.y * f.y;
  float trace = spread * (footprint.x * dot(q[0], q[0]) + footprint.y * dot(q[1], q[1]) +
                          footprint.z * dot(q[0], q[1]));
  float area = spread * determinant(q);
  return lichenKernelRetained(
      cycles, trace, area * area * (footprint.x * footprint.y - 0.25 * footprint.z * footprint.z));
}

/// The factors of a kernel's four waves, for each channel.
struct LichenKernelColors {
  vec4 channel0, channel1, channel2;
};
LichenKernelColors lichenKernelColors(LICHEN_IMAGE_2D image, int row) {
  return LichenKernelColors(LICHEN_FETCH_2D(image, ivec2(3, row)),
                            LICHEN_FETCH_2D(image, ivec2(4, row)),
                            LICHEN_FETCH_2D(image, ivec2(5, row)));
}

/// The sum of their squares: what the kernel adds to the variance of all channels.
float lichenKernelSquares(LichenKernelColors colors) {
  return dot(colors.channel0, colors.channel0) + dot(colors.channel1, colors.channel1) +
         dot(colors.channel2, colors.channel2);
}

/// The four waves as channels.
vec3 lichenColored(LichenKernelColors colors, vec4 waves) {
  return vec3(dot(colors.channel0, waves), dot(colors.channel1, waves),
              dot(colors.channel2, waves));
}

/// The tiles in which a point's place is counted.
vec2 lichenKernelsTiles(LichenMaterial material) {
  bool isPeriodic = bool(LICHEN_PERIODIC_LATTICE) && material.periodRows != 0;
  return isPeriodic ? vec2(material.periodTilesX, material.periodTilesY)
                    : vec2(float(LICHEN_KERNEL_TILES));
}

/// The Gaussian value, in w the share of its variance that the footprint loses, averaged over the
/// channels. `slopes`: its derivatives along x and y [1 / tile], 0 unless `hasSlopes`, a constant.
vec4 lichenKernelsGaussian(LICHEN_IMAGE_2D image, LichenKernelsPoint point, LichenMaterial material,
                           LichenNoise noise, bool hasSlopes,
                           LICHEN_OUT(LichenGaussianSlopes) slopes) {
  LichenKernelsNoise kernels = lichenKernelsNoise(noise);
  vec3 footprint = lichenWaveFootprint(point.gradientX, point.gradientY,
                                       vec2(noise.tileTexelsX, noise.tileTexelsY));
  vec3 sum = vec3(0.0);
  slopes = LichenGaussianSlopes(vec3(0.0), vec3(0.0));
  float squares = 0.0, lost = 0.0;
  for (int k = 0; k < int(kernels.kernels); ++k) {
    LichenKernelColors colors = lichenKernelColors(image, k);
    LichenKernelRow row = lichenKernelRow(image, k, kernels);
    float retained = lichenKernelRetained(row, footprint, kernels.window);
    float own = lichenKernelSquares(colors);
    squares += own;
    lost += own * (1.0 - retained * retained);
    if (retained > 0.0 && own > 0.0) {
      LichenKernel kernel = lichenKernelAt(row, point, material);
      LichenKernelSums sums =
          lichenKernelSums(kernel, lichenPcg(point.seedWord + uint(k)), kernels.window, hasSlopes);
      sum += retained * lichenColored(colors, sums.waves);
      if (hasSlopes) {
        vec2 perTile = retained / kernel.perCell;
        slopes.alongX += perTile.x * lichenColored(colors, sums.alongX);
        slopes.alongY += perTile.y * lichenColored(colors, sums.alongY);
      }
    }
  }
  if (bool(LICHEN_KERNEL_PATTERN) && kernels.cosines != 0u) {
    vec2 position = point.inside * lichenKernelsTiles(material);
    LichenPattern pattern =
        lichenPatternAt(image, position, footprint, material, kernels, hasSlopes);
    sum += pattern.gaussian;
    slopes.alongX += pattern.slopes.alongX;
    slopes.alongY += pattern.slopes.alongY;
    squares += pattern.squares;
    lost += pattern.lost;
  }
  const float kLeast = 1.0e-20; // of a map that does not vary
  return vec4(0.5 + material.contrast * sum, lost / max(squares, kLeast));
}

vec4 lichenKernelsGaussian(LICHEN_IMAGE_2D image, LichenKernelsPoint point, LichenMaterial material,
                           LichenNoise noise) {
  LichenGaussianSlopes none;
  return lichenKernelsGaussian(image, point, material, noise, false, none);
}

// The seam's functions; see method.glsl.

void lichenSetPoint(LICHEN_OUT(LichenKernelsPoint) point, vec2 position, vec2 gradientX,
                    vec2 gradientY, LichenMaterial material, LichenNoise noise) {
  vec2 place = position / lichenKernelsTiles(material);
  vec2 group = floor(place);
  point.inside = place - group;
  point.group = ivec2(group) + ivec2(material.cellI, material.cellJ);
  point.seedWord = material.seedWord;
  point.gradientX = gradientX;
  point.gradientY = gradientY;
}

vec3 lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenKernelsPoint point,
                      LichenMaterial material, LichenNoise noise, LichenMap map,
                      LICHEN_OUT(vec3) lost) {
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

/// The value of a map's first channel and its derivatives along x and y of tile space [1 / tile].
/// `position` is in tiles, the gradients of the pixel are in tiles / pixel; the mapping is uv.
vec3 lichenKernelsGradient(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, vec2 position,
                           vec2 gradientX, vec2 gradientY, LichenMaterial material,
                           LichenNoise noise, LichenMap map) {
  LichenKernelsPoint point;
  lichenSetPoint(point, position, gradientX, gradientY, material, noise);
  LichenGaussianSlopes slopes;
  vec4 gaussian = lichenKernelsGaussian(image, point, material, noise, true, slopes);
  return lichenDecodedGradient(table, gaussian, slopes, material.contrast, map);
}

#endif
