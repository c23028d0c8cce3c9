// SPDX-License-Identifier: MIT
// Rotated tiles: vertex -> (cosine, sine) of its tile's angle, a multiple of a quarter turn, so
// that texels lie on texels; positions and slopes -> the same, rotated.
// docs/decisions/001-tiling.md has what it is good for and what it costs.
#ifndef LICHEN_TILE_ROTATION_GLSL
#define LICHEN_TILE_ROTATION_GLSL

#include "hash.glsl"
#include "switches.glsl"

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

#endif
