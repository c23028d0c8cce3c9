// SPDX-License-Identifier: MIT
// Histogram-preserving tiling and blending [HN18], from top to bottom: a point on the plane of
// tiles and its footprint -> three tiles and their weights, once for all maps -> the Gaussian value
// of each map and the share of its variance that fetches lose -> the decoded value.
// [HN18] Heitz and Neyret 2018, Algorithm 1. Deviations, with reasons: docs/decisions/001-tiling.md.

/// The number of angles that tiles take: 2 or, of square tiles, 4. 0 and 1: no rotation. Known at
/// compile time where no material rotates tiles.
uint lichenTileAngles(LichenMaterial material) {
  return LICHEN_USES(LICHEN_FEATURE_TILE_ROTATION) ? lichenTilingMaterial(material).tileRotation
                                                   : 0u;
}

/// The rotation of a vertex's tile: (cosine, sine) of its angle.
vec2 lichenTileRotationAt(uvec2 vertex, LichenMaterial material) {
  uint angles = lichenTileAngles(material);
  if (angles <= 1u)
    return vec2(1.0, 0.0);
  // Hashed again: both halves of the vertex's hash are the offset.
  uint hash = lichenPcg(lichenVertexHash(vertex.x, vertex.y, material.seedWord));
  uint quarters = (hash >> 30u) & (angles == 2u ? 2u : 3u);
  float sign = (quarters & 2u) == 0u ? 1.0 : -1.0;
  return (quarters & 1u) == 0u ? vec2(sign, 0.0) : vec2(0.0, sign);
}

/// A position on the plane [tiles] -> the position in the exemplar of a tile that is rotated.
/// Slopes in that exemplar, whose y points up, against v -> slopes on the plane.
vec2 lichenRotated(vec2 v, vec2 rotation) {
  return vec2(rotation.x * v.x - rotation.y * v.y, rotation.x * v.y + rotation.y * v.x);
}

/// What all maps of a noise share at one point.
struct LichenTilingPoint {
  vec2 uv0, uv1, uv2; // [tiles] where the tile of each vertex is fetched
  vec3 weights;
  float footprintLevel; // [mip levels] of the widest map
  float lossShare;      // what a fetch loses at this position, over its mean; of the widest map
  vec2 rotation0, rotation1, rotation2; // (cosine, sine) of each tile's angle
  vec2 gradientX, gradientY; // [tiles / pixel] of the position; a tile's own jump
};

/// The random offset of a vertex's tile, a whole number of texels; images repeat. [tiles]
vec2 lichenTileOffset(uvec2 vertex, LichenMaterial material, LichenNoise noise) {
  uint hash = lichenVertexHash(vertex.x, vertex.y, material.seedWord);
  // Through int: float of uint is slower on devices with only signed conversions.
  ivec2 steps = ivec2(uvec2(hash & 0x7ffu, hash >> 21u));
  return vec2(steps) * vec2(noise.offsetStepX, noise.offsetStepY);
}

/// Where the tile of a vertex is fetched [tiles]; its rotation.
vec2 lichenTileAt(uvec2 vertex, vec2 position, LichenMaterial material, LichenNoise noise,
                  LICHEN_OUT(vec2) rotation) {
  vec2 uv = position - lichenReduceToPeriod(vertex, material);
  rotation = lichenTileRotationAt(vertex, material);
  if (lichenTileAngles(material) > 1u)
    uv = lichenRotated(uv, rotation);
  return uv + lichenTileOffset(vertex, material, noise);
}

/// Tiles and weights at `position` [tiles, relative to the host's integer tile origin] of a pixel
/// with these gradients [tiles / pixel].
void lichenSetPoint(LICHEN_OUT(LichenTilingPoint) point, vec2 position, vec2 gradientX,
                    vec2 gradientY, LichenMaterial material, LichenNoise noise) {
  // Lattices that are neither stretched nor periodic all have the same cells.
  vec2 skewed = vec2(3.5 * position.x - 2.0 * position.y, 4.0 * position.y);
  if (LICHEN_USES(LICHEN_FEATURE_GRAIN | LICHEN_FEATURE_PERIOD))
    skewed = lichenSkewed(position, material);
  LichenTriangle triangle = lichenTriangle(skewed, material);
  point.uv0 = lichenTileAt(triangle.vertex0, position, material, noise, point.rotation0);
  point.uv1 = lichenTileAt(triangle.vertex1, position, material, noise, point.rotation1);
  point.uv2 = lichenTileAt(triangle.vertex2, position, material, noise, point.rotation2);
  point.weights = triangle.weights;
  float sharpness = lichenTilingMaterial(material).blendSharpness;
  if (LICHEN_USES(LICHEN_FEATURE_BLEND_SHARPNESS) && sharpness != 1.0) {
    point.weights = pow(point.weights, vec3(sharpness));
    point.weights /= point.weights.x + point.weights.y + point.weights.z;
  }
  vec2 texels = vec2(noise.tileTexelsX, noise.tileTexelsY);
  point.footprintLevel = lichenFootprintLevel(gradientX * texels, gradientY * texels);
  point.lossShare = lichenLossShare(position * texels, gradientX * texels, gradientY * texels,
                                    point.footprintLevel);
  point.gradientX = gradientX;
  point.gradientY = gradientY;
}

/// The mip level at which a map is fetched.
float lichenTilingLevel(LichenTilingPoint point, LichenMaterial material, LichenNoise noise,
                        LichenMap map) {
#if LICHEN_ANISOTROPIC
  vec2 texels = exp2(map.levelOffset) * vec2(noise.tileTexelsX, noise.tileTexelsY);
  return lichenAnisotropicLevel(point.gradientX * texels, point.gradientY * texels,
                                material.maxAnisotropy);
#else
  return lichenSharpLevel(point.footprintLevel + map.levelOffset);
#endif
}

/// The tiles of a map at a point: rgb are Gaussian values, alpha is the share of the variance that
/// fetches lose on average over all positions.
struct LichenTiles {
  vec4 tile0, tile1, tile2;
};
LichenTiles lichenTilesAt(LICHEN_IMAGE_2D image, LichenTilingPoint point, LichenMaterial material,
                          LichenNoise noise, LichenMap map) {
  float level = lichenTilingLevel(point, material, noise, map);
  LichenTiles tiles;
#if LICHEN_ANISOTROPIC
  vec2 x = point.gradientX, y = point.gradientY;
  tiles.tile0 = LICHEN_SAMPLE_2D_GRAD(image, point.uv0, lichenRotated(x, point.rotation0),
                                      lichenRotated(y, point.rotation0));
  tiles.tile1 = LICHEN_SAMPLE_2D_GRAD(image, point.uv1, lichenRotated(x, point.rotation1),
                                      lichenRotated(y, point.rotation1));
  tiles.tile2 = LICHEN_SAMPLE_2D_GRAD(image, point.uv2, lichenRotated(x, point.rotation2),
                                      lichenRotated(y, point.rotation2));
  // Alpha does not tell what an anisotropic sampler's probes lose together.
  tiles.tile0.a = tiles.tile1.a = tiles.tile2.a = LICHEN_SAMPLE_2D(image, point.uv0, level).a;
#else
  tiles.tile0 = LICHEN_SAMPLE_2D(image, point.uv0, level);
  tiles.tile1 = LICHEN_SAMPLE_2D(image, point.uv1, level);
  tiles.tile2 = LICHEN_SAMPLE_2D(image, point.uv2, level);
#endif
  return tiles;
}

// The image holds the mean of Gaussian values as a value of 8 bits.
const float kLichenStoredMean = 128.0 / 255.0;

/// The tiles blended: mean 1/2 and deviation 1/6 where nothing is minified, the loss in alpha.
vec4 lichenBlend(LichenTiles tiles, vec3 weights, float contrast) {
  // [HN18] eq. 8 on Gaussian values, about their mean.
  vec4 blend = weights.x * tiles.tile0 + weights.y * tiles.tile1 + weights.z * tiles.tile2;
  float gain = contrast * inversesqrt(dot(weights, weights));
  return vec4(0.5 + gain * (blend.rgb - kLichenStoredMean), blend.a);
}

/// The loss at this position, over the average. Smaller maps use the average: their tiles are not
/// offset by whole texels.
float lichenTilingLossShare(LichenTilingPoint point, LichenMap map) {
  return map.levelOffset == 0.0 ? point.lossShare : 1.0;
}

LichenGaussian lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
                                LichenTilingPoint point, LichenMaterial material, LichenNoise noise,
                                LichenMap map) {
  vec4 blend = lichenBlend(lichenTilesAt(image, point, material, noise, map), point.weights,
                           material.contrast);
  return LichenGaussian(blend.rgb, vec3(blend.a * lichenTilingLossShare(point, map)), 0.0);
}

/// Decodes a Gaussian value whose alpha is the average loss. Slope variance that only interpolation
/// loses does not make the material rougher.
vec4 lichenTilingDecoded(LICHEN_IMAGE_3D table, vec4 gaussian, float lossShare, float contrast,
                         LichenMap map) {
  LichenGaussian here = LichenGaussian(gaussian.rgb, vec3(lossShare * gaussian.a), 0.0);
  vec4 value = lichenDecode(table, here, contrast, map);
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    value.z *= lichenFootprintShare(gaussian.a, map.interpolationLoss);
  return value;
}

/// The value of a map at a point.
vec4 lichenTilingValue(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenTilingPoint point,
                       LichenMaterial material, LichenNoise noise, LichenMap map) {
  LichenTiles tiles = lichenTilesAt(image, point, material, noise, map);
  vec4 blend = lichenBlend(tiles, point.weights, material.contrast);
  float lossShare = lichenTilingLossShare(point, map);
  // The slopes of rotated tiles are decoded one by one, rotated back and blended about 0, where
  // rotation leaves their mean: a joint table knows slopes as they lie in the exemplar. One loop
  // for both, tested at both ends, as lichenTriplanarGaussian has it: devices that run both sides
  // of a branch leave a loop when no pixel has more.
  bool isEach = map.encoding == uint(LICHEN_ENCODING_SLOPE) && lichenTileAngles(material) > 1u;
  vec3 shares = point.weights * inversesqrt(dot(point.weights, point.weights));
  int count = isEach ? 3 : 1;
  vec4 sum = vec4(0.0, 0.0, 0.0, 1.0);
  int tile = 0;
  while (tile < count) {
    vec4 each = tile == 0 ? tiles.tile0 : (tile == 1 ? tiles.tile1 : tiles.tile2);
    each = isEach ? vec4(0.5 + material.contrast * (each.rgb - kLichenStoredMean), each.a) : blend;
    vec4 value = lichenTilingDecoded(table, each, lossShare, material.contrast, map);
    vec2 rotation = tile == 0 ? point.rotation0 : (tile == 1 ? point.rotation1 : point.rotation2);
    float share = tile == 0 ? shares.x : (tile == 1 ? shares.y : shares.z);
    if (isEach)
      sum += vec4(share * lichenRotated(value.xy, rotation), share * share * value.z, 0.0);
    else
      sum = value;
    ++tile;
    if (tile >= count)
      break;
  }
  return sum;
}
