// SPDX-License-Identifier: MIT
// Multiple-kernels noise on a surface: a point in space and the frame of its tangent plane -> for
// each kernel the sum over impacts around the point, projected onto that plane -> the Gaussian
// value and the share of its variance that the footprint loses. The image is the plane's.
// docs/decisions/010-multiple-kernels.md

#if LICHEN_HAS_SURFACES
/// The cubes of a kernel's grid around a point. Offsets are in the window's coordinates.
LichenSurfaceCubes lichenKernelCubes(LichenKernelRow row, LichenKernelsPoint point,
                                     float aspect, float greatestHeight, uint seed) {
  float side = float(LICHEN_KERNEL_TILES) / row.cubes;         // [tile widths]
  vec3 right = point.frame[0], down = aspect * point.frame[1]; // [tiles]
  mat3 axes = mat3(side * (row.toWindow[0].x * right + row.toWindow[1].x * down),
                   side * (row.toWindow[0].y * right + row.toWindow[1].y * down),
                   side / greatestHeight * point.frame[2]);
  vec3 grid = point.inside * row.cubes;
  vec3 corner = floor(grid);
  uvec3 cell = uvec3(ivec3(corner)) + uvec3(point.group) * uint(int(row.cubes));
  return lichenSurfaceCubesAt(grid - corner, cell, axes, vec3(0.0), vec3(1.0), seed, false);
}

/// The sums over the impacts of a kernel that reach the point, of their four waves.
vec4 lichenSurfaceKernelSums(LichenKernelRow row, LichenKernelsPoint point, float aspect,
                             uint seed, uint window) {
  // The layer is as thick as the square root of the support's area. Over it the squared weight is a
  // third on average ([GLM17] proposition 3), and the amplitude makes up for that and for the
  // density.
  float perWidth = abs(determinant(row.toWindow)) * aspect; // of the area [1 / tile width^2]
  float supportArea = (lichenIsOnDisk(window) ? 3.14159265 : 4.0) / perWidth;
  float thickness = sqrt(supportArea);
  vec2 cellsPerTile = row.cells / float(LICHEN_KERNEL_TILES);
  float cubesPerWidth = row.cubes / float(LICHEN_KERNEL_TILES);
  float density = cubesPerWidth * cubesPerWidth * cubesPerWidth;
  float amplitude =
      row.amplitude * sqrt(3.0 * cellsPerTile.x * cellsPerTile.y * aspect / (density * thickness));
  // The wave in the window's coordinates.
  mat2 toTiles = inverse(row.toWindow);
  vec2 frequency = row.frequency * toTiles;
  LichenSurfaceCubes cubes = lichenKernelCubes(row, point, aspect, 0.5 * thickness, seed);
  vec4 sums = vec4(0.0);
  LichenSurfaceWalk walk = lichenFirstSurfaceImpact(cubes);
  while (lichenHasImpact(walk, cubes)) {
    lichenSurfaceStep(walk, cubes);
    if (!walk.isReached)
      continue;
    uint word = lichenPcg(~walk.word);
    if (row.isRing) {
      uint turns = lichenRingTurns(walk.cell.x, walk.cell.y, seed + walk.cell.z * 0xABC98389u);
      frequency = row.frequency.x * lichenRingDirection(turns) * toTiles;
    }
    float phase = dot(frequency, walk.offset) + lichenKernelPhase(word);
    sums += lichenKernelWaves(walk.weight * lichenKernelWindow(walk.offset, window) *
                                  lichenCosineOfTurns(vec4(phase)).x,
                              word);
  }
  return amplitude * sums;
}

/// Sets where a point lies on a surface. lichenSetPoint has set its footprint in the tangent plane.
void lichenSetSurfacePoint(LICHEN_INOUT(LichenKernelsPoint) point, vec3 position, mat3 frame,
                           LichenMaterial material, LichenNoise noise) {
  LichenKernelsMaterial own = lichenKernelsMaterial(material);
  vec3 offset = vec3(material.offsetX, material.offsetY, own.offsetZ);
  vec3 place = (position + offset) / float(LICHEN_KERNEL_TILES);
  vec3 group = floor(place);
  point.inside = place - group;
  point.group = ivec3(group) + ivec3(material.cellI, material.cellJ, own.cellK);
  point.frame = frame;
}

LichenGaussian lichenSurfaceGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
                                       LichenKernelsPoint point, LichenMaterial material,
                                       LichenNoise noise, LichenMap map) {
  LichenKernelsNoise kernels = lichenKernelsNoise(noise);
  vec3 footprint = lichenWaveFootprint(point.gradientX, point.gradientY,
                                       vec2(noise.tileTexelsX, noise.tileTexelsY));
  vec3 sum = vec3(0.0);
  float squares = 0.0, lost = 0.0;
  for (int k = 0; k < int(kernels.kernels); ++k) {
    LichenKernelColors colors = lichenKernelColors(image, k);
    LichenKernelRow row = lichenKernelRow(image, k, kernels);
    float retained = lichenKernelRetained(row, footprint, kernels.window);
    float own = lichenKernelSquares(colors);
    squares += own;
    lost += own * (1.0 - retained * retained);
    if (retained > 0.0 && own > 0.0)
      sum += retained *
             lichenColored(colors, lichenSurfaceKernelSums(row, point, noise.tileAspect,
                                                           lichenPcg(point.seedWord + uint(k)),
                                                           kernels.window));
  }
  return lichenOfKernels(sum, squares, lost, 0.0, material);
}
#endif
