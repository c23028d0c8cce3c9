// SPDX-License-Identifier: MIT
// A kernel of multiple-kernels noise [MKN12]: a row of an image -> its grid, wave and window around
// a point; impacts -> their waves; a footprint -> what it leaves of the kernel.
// [MKN12] Gilet, Dischler and Ghazanfarpour 2012. Deviations, with reasons:
// docs/decisions/010-multiple-kernels.md.

/// What all maps of a noise share at one point.
struct LichenKernelsPoint {
  // The group of LICHEN_KERNEL_TILES tiles that holds the point; without a period modulo 2^32. On
  // surfaces and in solids of tile widths, also along z.
  ivec3 group;
  vec3 inside;   // the place in it, or in the period, [0, 1)
  uint seedWord; // of the plane
  vec2 gradientX, gradientY; // [tiles / pixel], but of a solid
#if LICHEN_HAS_SURFACES
  mat3 frame; // of a surface: to the right, down and outward in the exemplar
#endif
#if LICHEN_HAS_SOLIDS
  LichenSolidFootprint footprint; // of a solid
#endif
};

/// One row of an image.
struct LichenKernelRow {
  vec2 frequency; // [cycles / tile]; of a ring, (radius, 0)
  bool isRing;
  vec2 cells;    // columns and rows of its grid in LICHEN_KERNEL_TILES tiles
  mat2 toWindow; // Q: from an offset in tiles to the window's coordinates
  float amplitude;
  float cubes;             // on surfaces, cubes of its grid in LICHEN_KERNEL_TILES tile widths
  float layers;            // in solids, layers of its grid in as many tile widths
  float toWindowZ;         // in solids, Q along z
};

/// The row `row` of an image.
LichenKernelRow lichenKernelRow(LICHEN_IMAGE_2D image, int row, LichenKernelsNoise kernels) {
  vec4 grid = LICHEN_FETCH_2D(image, ivec2(0, row));
  vec4 window = LICHEN_FETCH_2D(image, ivec2(1, row));
  vec4 scales = LICHEN_FETCH_2D(image, ivec2(2, row));
  const float kOfWave = 1.41421356; // whose square is 1 in the mean
  bool isRing =
      LICHEN_USES(LICHEN_FEATURE_RING_KERNELS) && row >= int(kernels.kernels - kernels.rings);
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
  bool isPeriodic = lichenIsPeriodic(material);
  if (isPeriodic) {
    vec2 tiles = vec2(material.periodTilesX, material.periodTilesY);
    cells = max(floor(perTile * tiles + 0.5), 1.0);
    kernel.period = ivec2(cells);
    vec2 fitted = cells / tiles;
    // As many impacts as the period's cells have.
    kernel.amplitude *= sqrt((perTile.x * perTile.y) / (fitted.x * fitted.y));
    perTile = fitted;
  }
  vec2 position = point.inside.xy * cells;
  vec2 corner = floor(position);
  kernel.place = position - corner;
  kernel.corner = uvec2(ivec2(corner));
  if (!isPeriodic) // a place of almost 1 may round to it, which is the next group's corner
    kernel.corner += uvec2(point.group.xy) * uvec2(ivec2(cells));
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
  bool hasSquares = LICHEN_USES(LICHEN_FEATURE_SQUARE_KERNELS);
  return !hasSquares || window == uint(LICHEN_WINDOW_GABOR);
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

/// The phase of an impact, by a bit of its random numbers: an eighth of a turn, so that slow
/// kernels are as strong as others. [turns]
float lichenKernelPhase(uint word) { return float(int((word >> 4u) & 1u)) * 0.25 - 0.125; }

/// The wave of an impact -> its four waves, which differ in their signs, by bits of its random
/// numbers.
vec4 lichenKernelWaves(float wave, uint word) {
  uvec4 signs = (uvec4(word) << uvec4(31u, 30u, 29u, 28u)) & 0x80000000u;
  return uintBitsToFloat(uvec4(floatBitsToUint(wave)) ^ signs);
}

/// The direction of a ring's impact in a cell [2^-32 turns]. Neighbours' directions are spread
/// evenly, by 2^32 over the plastic number and over its square: of few random ones some would stand
/// out.
uint lichenRingTurns(uint column, uint row, uint seed) {
  return column * 0xC13FA9A9u + row * 0x91E10DA5u + seed;
}

vec2 lichenRingDirection(uint turns) {
  const float kPerBit = 1.0 / 4294967296.0; // of signed integers: -1/2 to 1/2
  float direction = kPerBit * float(int(turns));
  return lichenCosineOfTurns(vec4(direction, direction - 0.25, 0.0, 0.0)).xy;
}

/// The four waves of an impact at a point. `word`: its random numbers; `turns`: its direction, of a
/// ring; `offset` from it to the point.
vec4 lichenKernelImpact(uint word, uint turns, vec2 offset, LichenKernel kernel, uint window) {
  vec2 frequency = kernel.frequency;
  if (kernel.isRing)
    frequency = kernel.frequency.x * lichenRingDirection(turns) * kernel.perCell;
  float phase = dot(frequency, offset) + lichenKernelPhase(word);
  float wave = lichenCosineOfTurns(vec4(phase)).x;
  return lichenKernelWaves(lichenKernelWindow(kernel.toWindow * offset, window) * wave, word);
}

/// Where an impact lies in its cell, [0, 1).
vec2 lichenKernelPlace(uint word) {
  // 11 bits along each axis, and the middle of what they tell apart.
  const float kStep = 1.0 / 2048.0;
  return (vec2(ivec2(uvec2(word >> 21u, word >> 10u) & 2047u)) + 0.5) * kStep;
}

/// The amplitude that a pixel leaves of a kernel. `cycles`: the square of those that it spans of
/// the wave; trace and determinant belong to the matrix of squared cycles that it spans
/// of the window's spectrum.
float lichenKernelRetained(float cycles, float trace, float determinant) {
  // A pixel spans the cycles A f of a frequency f. This is the root of the mean of exp(-|A f|^2)
  // over frequencies that are normally distributed about the wave's; exact where the window adds as
  // much along both axes. For few cycles it is the same as lichenCosineRetained.
  const float kSlope = 6.57973627; // 2 pi^2 / 3
  float wider = sqrt(max(1.0 + kSlope * (trace + kSlope * determinant), 1.0));
  float retained = lichenCosineRetained(vec4(cycles / wider)).x * inversesqrt(wider);
  // Such a spectrum has no end; but a faint kernel that is smaller than the pixel flickers.
  const float kFaint = 0.3;
  return max((1.0 + kFaint) * retained - kFaint, 0.0);
}

/// The mean square frequency of a window along each of its axes. [cycles^2]
float lichenKernelSpread(uint window) {
  // 21 / (20 pi^2) for gabor; quadrature gave the values of the other windows.
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

/// The Gaussian value of sums over kernels: of values less their mean, of the variance of all
/// channels, and of what the footprint takes of it.
LichenGaussian lichenOfKernels(vec3 sum, float squares, float lost, float depthSlope,
                               LichenMaterial material) {
  const float kLeast = 1.0e-20; // of a map that does not vary
  return LichenGaussian(0.5 + material.contrast * sum, vec3(lost / max(squares, kLeast)),
                        material.contrast * depthSlope);
}
