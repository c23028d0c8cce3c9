// SPDX-License-Identifier: MIT
// Multiple-kernels noise in a solid: a point in space and its footprint -> for each kernel the sum
// over the impacts around it -> the Gaussian value and the share of its variance that the footprint
// loses. Kernels of the plane become ellipsoids with waves in space; the image stays the same.
// docs/decisions/010-multiple-kernels.md

#if LICHEN_HAS_SOLIDS
/// A kernel in space. Offsets along z are in layers of cells.
struct LichenSolidKernel {
  LichenKernel plane;
  vec2 frequency;  // [cycles / tile width]; of a ring, (radius, 0)
  float aspect;    // of a tile: its width over its height
  float perLayer;  // [tile widths] height of a cell
  float toWindowZ; // from an offset in layers to the window's third coordinate
  uint layer;      // the one that holds the point; its place in that:
  float place;     // [0, 1)
  // The squared cycles that a pixel spans of a wave with the third frequency z are
  // cycles.x + z (cycles.y + z cycles.z); of the window as lichenKernelRetained takes them.
  vec3 cycles;
  float trace, determinant;
  // The spread of the window along z, and along the wave in the plane. [cycles^2 / tile width^2]
  float depthSpread, planarSpread;
};

/// Sums over impacts: of their four waves, and of slopes these times the slope along z for one
/// along x and for one along y.
struct LichenSolidKernelSums {
  vec4 waves, depthX, depthY;
};

/// The kernel of a row around a point.
LichenSolidKernel lichenSolidKernelAt(LichenKernelRow row, LichenKernelsPoint point,
                                      LichenMaterial material, LichenNoise noise) {
  LichenSolidKernel kernel;
  kernel.plane = lichenKernelAt(row, point, material);
  kernel.aspect = noise.tileAspect;
  kernel.frequency = row.isRing ? row.frequency : row.frequency * vec2(1.0, kernel.aspect);
  // Windows in space are wider by the root of 15 / 14: planes then have the spread of the window in
  // the plane. The integral of a squared window there is 0.6365 times that in the plane.
  const float kShrink = 0.966091783, kIntegral = 0.636518;
  float layersPerTile = row.layers / float(LICHEN_KERNEL_TILES);
  kernel.plane.amplitude *=
      sqrt(kShrink * kShrink * kShrink * row.toWindowZ / (kIntegral * layersPerTile));
  kernel.perLayer = 1.0 / layersPerTile;
  float position = point.inside.z * row.layers;
  float corner = floor(position);
  kernel.place = position - corner;
  kernel.layer = uint(int(corner)) + uint(point.group.z) * uint(int(row.layers));
  LichenSolidFootprint axes = point.footprint;
  // The axes in the coordinates of the window, and along the wave: rings have all directions.
  vec3 windowA = vec3(row.toWindow * axes.a.xy, row.toWindowZ * axes.a.z);
  vec3 windowB = vec3(row.toWindow * axes.b.xy, row.toWindowZ * axes.b.z);
  vec2 ofPlane = vec2(dot(row.frequency, axes.a.xy), dot(row.frequency, axes.b.xy));
  vec2 ofDepth = vec2(axes.a.z, axes.b.z);
  if (row.isRing)
    ofPlane = row.frequency.x * sqrt(0.5) * vec2(length(axes.a.xy), length(axes.b.xy));
  float both = row.isRing ? 0.0 : 2.0 * dot(ofPlane, ofDepth);
  kernel.cycles = vec3(dot(ofPlane, ofPlane), both, dot(ofDepth, ofDepth));
  float spread = lichenKernelSpread(uint(LICHEN_WINDOW_GABOR));
  vec3 ofWindow =
      spread * vec3(dot(windowA, windowA), dot(windowB, windowB), dot(windowA, windowB));
  kernel.trace = ofWindow.x + ofWindow.y;
  kernel.determinant = ofWindow.x * ofWindow.y - ofWindow.z * ofWindow.z;
  vec2 column0 = row.toWindow[0], column1 = kernel.aspect * row.toWindow[1];
  kernel.planarSpread = 0.5 * spread * (dot(column0, column0) + dot(column1, column1));
  kernel.depthSpread = spread * row.toWindowZ * row.toWindowZ;
  kernel.plane.toWindow *= kShrink;
  kernel.toWindowZ = kShrink * row.toWindowZ * kernel.perLayer;
  return kernel;
}

/// The amplitude that a pixel leaves of a wave with the third frequency z.
float lichenSolidRetained(float z, LichenSolidKernel kernel) {
  vec3 cycles = kernel.cycles;
  return lichenKernelRetained(cycles.x + z * (cycles.y + z * cycles.z), kernel.trace,
                              kernel.determinant);
}

/// The mean of its square over all third frequencies, and in y the most that it is.
vec2 lichenSolidRetainedSquare(LichenSolidKernel kernel) {
  float most = kLichenMostDepth * length(kernel.frequency);
  // By three of Gauss's points.
  const float kNode = 0.774596669;
  vec3 at = vec3(lichenSolidRetained(-kNode * most, kernel), lichenSolidRetained(0.0, kernel),
                 lichenSolidRetained(kNode * most, kernel));
  float least = clamp(-0.5 * kernel.cycles.y / max(kernel.cycles.z, 1.0e-20), -most, most);
  return vec2(dot(at * at, vec3(5.0, 8.0, 5.0) / 18.0), lichenSolidRetained(least, kernel));
}

/// Adds one impact. `word`: its random numbers, `turns`: its direction, of a ring; `depth` in
/// [-1, 1) its share of the largest third frequency; `offset` from it to the point [cells, layers].
void lichenAddSolidImpact(LICHEN_INOUT(LichenSolidKernelSums) sums, uint word, uint turns,
                          float depth, vec3 offset, LichenSolidKernel kernel, bool isSlope) {
  vec3 place = vec3(kernel.plane.toWindow * offset.xy, kernel.toWindowZ * offset.z);
  float left = max(1.0 - dot(place, place), 0.0);
  vec3 distance = offset * vec3(kernel.plane.perCell, kernel.perLayer);
  vec2 planar = kernel.frequency;
  if (kernel.plane.isRing)
    planar = kernel.frequency.x * lichenRingDirection(turns) * vec2(1.0, kernel.aspect);
  float square = dot(planar, planar);
  float z = kLichenMostDepth * depth * sqrt(square);
  float phase = planar.x * distance.x + planar.y * distance.y / kernel.aspect + z * distance.z +
                lichenKernelPhase(word);
  float value = left * left * left * lichenSolidRetained(z, kernel);
  vec4 waves = lichenKernelWaves(value * lichenCosineOfTurns(vec4(phase)).x, word);
  sums.waves += waves;
  if (isSlope) {
    // As lichenAddSolidVertex has it, with what the window adds to both frequencies.
    // The slope of a kernel without a wave lies along x.
    float ratio = sqrt((z * z + kernel.depthSpread) / (square + kernel.planarSpread));
    vec2 slope = (depth < 0.0 ? -ratio : ratio) * normalize(vec2(planar.x + 1.0e-6, -planar.y));
    sums.depthX += slope.x * waves;
    sums.depthY += slope.y * waves;
  }
}

/// The sums over the impacts of a kernel that reach the point.
LichenSolidKernelSums lichenSolidKernelSums(LichenSolidKernel kernel, uint seed, bool isSlope) {
  // As lichenKernelSum, in each layer with the chords of an ellipse that is smaller there.
  mat2 q = kernel.plane.toWindow;
  float xx = dot(q[0], q[0]), product = dot(q[0], q[1]), yy = dot(q[1], q[1]);
  float perY = yy - product * product / xx, perZ = kernel.toWindowZ * kernel.toWindowZ;
  float reachY = inversesqrt(perY), reachZ = 1.0 / kernel.toWindowZ;
  float shear = product / xx;
  LichenSolidKernelSums sums = LichenSolidKernelSums(vec4(0.0), vec4(0.0), vec4(0.0));
  int first = int(floor(kernel.plane.place.y - reachY));
  int last = int(floor(kernel.plane.place.y + reachY));
  int lastLayer = int(floor(kernel.place + reachZ));
  int j = first;
  // One loop over the rows of all layers: Mesa 22.3's lavapipe crashes with four in each other.
  for (int k = int(floor(kernel.place - reachZ)); k <= lastLayer;) {
    vec2 low = vec2(kernel.plane.place.y, kernel.place) - vec2(ivec2(j, k)) - 1.0;
    vec2 near = clamp(vec2(0.0), low, low + 1.0);
    float rest = 1.0 - near.x * near.x * perY - near.y * near.y * perZ;
    float chord = sqrt(max(rest, 0.0) / xx);
    float middleLow = -shear * low.x, middleHigh = -shear * (low.x + 1.0);
    int end = int(floor(kernel.plane.place.x - min(middleLow, middleHigh) + chord));
    int i = int(floor(kernel.plane.place.x - max(middleLow, middleHigh) - chord));
    if (rest <= 0.0)
      i = end + 1;
    uint row = kernel.plane.corner.y + uint(j);
    uint layer = kernel.layer + uint(k);
    uint layerSeed = lichenPcg(seed + layer);
    for (; i <= end; ++i) {
      uint column = kernel.plane.corner.x + uint(i);
      uint word = lichenVertexHash(column, row, layerSeed);
      // Its place in the layer, and its third frequency: 16 bits each.
      uint other = lichenPcg(~word);
      const float kStep = 1.0 / 65536.0, kPerBit = 1.0 / 2147483648.0;
      float above = (float(int(other >> 16u)) + 0.5) * kStep;
      vec3 offset = vec3(kernel.plane.place - vec2(float(i), float(j)) - lichenKernelPlace(word),
                         kernel.place - float(k) - above);
      uint turns = lichenRingTurns(column, row, seed + layer * 0xABC98389u);
      lichenAddSolidImpact(sums, word, turns, kPerBit * float(int(other << 16u)), offset, kernel,
                           isSlope);
    }
    ++j;
    if (j > last) {
      j = first;
      ++k;
    }
  }
  sums.waves *= kernel.plane.amplitude;
  sums.depthX *= kernel.plane.amplitude;
  sums.depthY *= kernel.plane.amplitude;
  return sums;
}

void lichenSetSolidPoint(LICHEN_OUT(LichenKernelsPoint) point, vec3 position,
                         LichenSolidFootprint footprint, LichenMaterial material) {
  LichenKernelsMaterial own = lichenKernelsMaterial(material);
  vec3 place = (position + vec3(0.0, 0.0, own.offsetZ)) / float(LICHEN_KERNEL_TILES);
  vec3 group = floor(place);
  point.inside = place - group;
  point.group = ivec3(group) + ivec3(material.cellI, material.cellJ, own.cellK);
  point.seedWord = material.seedWord;
  point.footprint = footprint;
}

LichenGaussian lichenSolidGaussianAt(LICHEN_IMAGE_2D image, LichenKernelsPoint point,
                                     LichenMaterial material, LichenNoise noise, LichenMap map) {
  bool isSlope = map.encoding == uint(LICHEN_ENCODING_SLOPE);
  vec3 sum = vec3(0.0);
  float squares = 0.0, lost = 0.0, depthSlope = 0.0;
  LichenKernelsNoise kernels = lichenKernelsNoise(noise);
  for (int k = 0; k < int(kernels.kernels); ++k) {
    LichenKernelColors colors = lichenKernelColors(image, k);
    LichenSolidKernel kernel =
        lichenSolidKernelAt(lichenKernelRow(image, k, kernels), point, material, noise);
    vec2 retained = lichenSolidRetainedSquare(kernel);
    float own = lichenKernelSquares(colors);
    squares += own;
    lost += own * (1.0 - retained.x);
    if (retained.y > 0.0 && own > 0.0) {
      LichenSolidKernelSums sums =
          lichenSolidKernelSums(kernel, lichenPcg(point.seedWord + uint(k)), isSlope);
      sum += lichenColored(colors, sums.waves);
      depthSlope += dot(map.row0.x * colors.channel0 + map.row0.y * colors.channel1, sums.depthX) +
                    dot(map.row1.x * colors.channel0 + map.row1.y * colors.channel1, sums.depthY);
    }
  }
  return lichenOfKernels(sum, squares, lost, depthSlope, material);
}
#endif
