// SPDX-License-Identifier: MIT
// Quilting: tiles of the exemplar, cut along the outlines of what they show. A point on the plane
// of tiles and its footprint -> two tiles and their weights, once for all maps -> the value of each
// map. Tiles are taken where the exemplar repeats, so that its structure goes on. A tile's weight
// is taken at the centre of the cell that it shows at the point: a brick is wholly of one tile.
// docs/decisions/012-quilting.md.

#if (LICHEN_METHODS & 16) != 0
/// What all maps of a noise share at one point.
struct LichenQuiltingPoint {
  vec2 uv0, uv1;        // [tiles] where two tiles are fetched
  vec2 weights;         // about the mean; their sum is at least 1 where contrast is
  uvec2 colors;         // lichenVertexColor() of their vertices, for debug views
  float footprintLevel; // [mip levels] of the widest map
};

/// Where the tile of a vertex is taken from [tiles]: a random one of a list, or a random multiple
/// of `step`.
vec2 lichenQuiltingOffset(uvec2 vertex, uint seedWord, uint offsets, vec2 step) {
  uint hash = lichenVertexHash(vertex.x, vertex.y, seedWord);
  if (offsets == 0u) // as of tiling
    return vec2(ivec2(uvec2(hash & 0x7ffu, hash >> 21u))) * step;
  uint word = LICHEN_TILE_OFFSET(((hash >> 16u) * offsets) >> 16u);
  return vec2(ivec2(uvec2(word & 0xFFFFu, word >> 16u))) * (1.0 / 65536.0);
}

/// 1 at a vertex, 0 on the hexagon of its neighbours, linear in between and beyond. `fromVertex` is
/// in skewed coordinates. [cells]
float lichenHat(vec2 fromVertex) {
  return 1.0 - max(max(abs(fromVertex.x), abs(fromVertex.y)), abs(fromVertex.x + fromVertex.y));
}

/// Returns where to fetch the tile of a vertex [tiles]. Sets `height` to the vertex's hat at the
/// centre of the tile's cell at this point, and `sharpness` to log2 of the steepness of the tile's
/// cuts, as a share of its greatest value.
vec2 lichenQuiltingTap(uvec2 vertex, vec2 fromVertex, vec2 position, float level,
                       LichenMaterial material, LichenNoise noise, LICHEN_OUT(float) height,
                       LICHEN_OUT(float) sharpness) {
  LichenQuiltingNoise shape = lichenQuiltingNoise(noise);
  vec2 tap = position - lichenReduceToPeriod(vertex, material);
  tap += lichenQuiltingOffset(vertex, material.seedWord, shape.offsets,
                              vec2(noise.offsetStepX, noise.offsetStepY));
  vec3 cell = LICHEN_SAMPLE_CELLS(tap, level).rgb;
  vec2 toCentre = shape.reach * (2.0 * cell.rg - 1.0);
  sharpness = cell.b;
  height = lichenHat(fromVertex + lichenSkewed(toCentre, material));
  return tap;
}

void lichenSetPoint(LICHEN_OUT(LichenQuiltingPoint) point, vec2 position, vec2 gradientX,
                    vec2 gradientY, LichenMaterial material, LichenNoise noise) {
  const float kMostSharpness = 4.0; // log2 of the steepness of cuts
  const float kLeastHat = 1e-3, kLeastWeight = 1e-6;
  LichenQuiltingNoise shape = lichenQuiltingNoise(noise);
  vec2 texels = vec2(noise.tileTexelsX, noise.tileTexelsY);
  point.footprintLevel = lichenFootprintLevel(gradientX * texels, gradientY * texels);
  // The nearest: between two levels cuts differ too little for a second fetch.
  float level = floor(lichenSharpLevel(point.footprintLevel + shape.cellLevelOffset) + 0.5);
  vec2 skewed = lichenSkewed(position, material);
  LichenTriangle triangle = lichenTriangle(skewed, material);
  vec2 inside = skewed - floor(skewed);
  bool isUpper = triangle.vertex0.x == triangle.vertex1.x;
  vec3 heights;
  float sharpness;
  point.uv0 = lichenQuiltingTap(triangle.vertex0, inside - (isUpper ? 1.0 : 0.0), position, level,
                                material, noise, heights.x, sharpness);
  point.uv1 = lichenQuiltingTap(triangle.vertex1, inside - vec2(1.0, 0.0), position, level,
                                material, noise, heights.y, sharpness);
  vec2 uv2 = lichenQuiltingTap(triangle.vertex2, inside - vec2(0.0, 1.0), position, level, material,
                               noise, heights.z, sharpness);
  heights = max(heights, kLeastHat);
  float highest = max(heights.x, max(heights.y, heights.z));
  vec3 weights = max(highest - exp2(kMostSharpness * sharpness) * (highest - heights), 0.0);
  // Only two tiles are fetched: the smallest weight is taken from all.
  weights -= min(weights.x, min(weights.y, weights.z));
  uint color = lichenVertexColor(triangle.vertex0); // the other vertices have the next two
  point.colors = uvec2(color, color + 1u);
  if (weights.x == 0.0) {
    point.uv0 = uv2;
    weights.x = weights.z;
    point.colors.x = color + 2u;
  } else if (weights.y == 0.0) {
    point.uv1 = uv2;
    weights.y = weights.z;
    point.colors.y = color + 2u;
  }
  point.colors %= 3u;
  point.weights = max(weights.xy, kLeastWeight);
  point.weights /= point.weights.x + point.weights.y;
  // Keeps the variance: [HN18] eq. 8 for tiles that correlate, which they do where cells are seen.
  float squares = dot(point.weights, point.weights);
  point.weights *=
      material.contrast * inversesqrt(mix(squares, 1.0, shape.correlation * sharpness));
}

/// What a texel stands for. Where these are slopes, z is the variance that the level lost.
vec3 lichenQuiltingDecode(vec3 texel, LichenMap map) {
  if (map.encoding == uint(LICHEN_ENCODING_ROOT))
    return texel * texel;
  if (map.encoding == uint(LICHEN_ENCODING_LOG2))
    return exp2(texel) - 1.0;
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    texel.z = max(0.0, texel.z - 0.5 * dot(texel.xy, texel.xy));
  return texel;
}

/// A tile's value about the mean, times its weight.
vec3 lichenQuiltingTile(LICHEN_IMAGE_2D image, vec2 uv, float weight, float level, LichenMap map) {
  vec3 texel = LICHEN_SAMPLE_2D(image, uv, level).rgb;
  return weight * (lichenQuiltingDecode(texel, map) - map.mean.xyz);
}

/// The value about its mean, in place of a Gaussian value.
LichenGaussian lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
                                LichenQuiltingPoint point, LichenMaterial material,
                                LichenNoise noise, LichenMap map) {
  float level = lichenSharpLevel(point.footprintLevel + map.levelOffset);
  return LichenGaussian(0.5 + lichenQuiltingTile(image, point.uv0, point.weights.x, level, map) +
                            lichenQuiltingTile(image, point.uv1, point.weights.y, level, map),
                        vec3(0.0), 0.0);
}
#endif
