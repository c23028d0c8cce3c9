// SPDX-License-Identifier: MIT
// Multiple-kernels noise [MKN12], from top to bottom: a point on the plane of tiles and its
// footprint -> for each kernel the cells of its grid in reach -> the sum of the kernel over their
// impacts, with the share of the variance that the footprint loses.
// [MKN12] Gilet, Dischler and Ghazanfarpour 2012.

/// The sum over the impacts of a kernel that reach the point, of their four waves.
vec4 lichenKernelSum(LichenKernel kernel, uint seed, uint window) {
  // The offsets that the window reaches: |Q d| < 1 of a disk. In a row of cells at least as far as
  // `near` along y, the chord of the ellipse; of a square, all of it.
  mat2 q = kernel.toWindow;
  float xx = dot(q[0], q[0]), product = dot(q[0], q[1]), yy = dot(q[1], q[1]);
  float determinant = xx * yy - product * product;
  bool isDisk = lichenIsOnDisk(window);
  float reachY = isDisk ? sqrt(xx / determinant) : 1.0 / abs(q[1].y);
  float shear = isDisk ? product / xx : 0.0;
  vec4 sum = vec4(0.0);
  int last = int(floor(kernel.place.y + reachY));
  for (int j = int(floor(kernel.place.y - reachY)); j <= last; ++j) {
    // Offsets along y.
    float low = kernel.place.y - float(j) - 1.0, high = kernel.place.y - float(j);
    float near = clamp(0.0, low, high);
    float chord = sqrt(max(1.0 - (isDisk ? near * near * determinant / xx : 0.0), 0.0) / xx);
    // Its middle, at both ends of the row.
    float middleLow = -shear * low, middleHigh = -shear * high;
    int end = int(floor(kernel.place.x - min(middleLow, middleHigh) + chord));
    uint row = uint(lichenWrapped(int(kernel.corner.y) + j, kernel.period.y));
    for (int i = int(floor(kernel.place.x - max(middleLow, middleHigh) - chord)); i <= end; ++i) {
      uint column = uint(lichenWrapped(int(kernel.corner.x) + i, kernel.period.x));
      uint word = lichenVertexHash(column, row, seed);
      vec2 offset = kernel.place - vec2(float(i), float(j)) - lichenKernelPlace(word);
      sum += lichenKernelImpact(word, lichenRingTurns(column, row, seed), offset, kernel, window);
    }
  }
  return kernel.amplitude * sum;
}

/// The tiles in which a point's place is counted.
vec2 lichenKernelsTiles(LichenMaterial material) {
  return lichenIsPeriodic(material) ? vec2(material.periodTilesX, material.periodTilesY)
                                    : vec2(float(LICHEN_KERNEL_TILES));
}

LichenGaussian lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
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
      sum += retained * lichenColored(colors, lichenKernelSum(lichenKernelAt(row, point, material),
                                                              lichenPcg(point.seedWord + uint(k)),
                                                              kernels.window));
  }
  if (LICHEN_USES(LICHEN_FEATURE_PATTERNS) && kernels.cosines != 0u) {
    vec2 position = point.inside.xy * lichenKernelsTiles(material);
    LichenPattern pattern = lichenPatternAt(image, position, footprint, material, kernels);
    sum += pattern.gaussian;
    squares += pattern.squares;
    lost += pattern.lost;
  }
  return lichenOfKernels(sum, squares, lost, 0.0, material);
}

void lichenSetPoint(LICHEN_OUT(LichenKernelsPoint) point, vec2 position, vec2 gradientX,
                    vec2 gradientY, LichenMaterial material, LichenNoise noise) {
  vec2 place = position / lichenKernelsTiles(material);
  vec2 group = floor(place);
  point.inside = vec3(place - group, 0.0);
  point.group = ivec3(ivec2(group) + ivec2(material.cellI, material.cellJ), 0);
  point.seedWord = material.seedWord;
  point.gradientX = gradientX;
  point.gradientY = gradientY;
}
