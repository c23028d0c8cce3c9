// SPDX-License-Identifier: MIT
// Rotated tiles: vertex -> (cosine, sine) of its tile's angle; offset on the plane -> offset in the
// rotated exemplar; slopes in the rotated exemplar -> slopes on the plane.
// Angles are in space, where texels are square. The CPU twin is analysis/tiling/tile_rotation;
// docs/decisions/024-tile-rotation.md has what it is good for and what it costs.
#ifndef LICHEN_TILE_ROTATION_GLSL
#define LICHEN_TILE_ROTATION_GLSL

#include "../interface/lichen_interface.h"
#include "hash.glsl"
#include "method_parts.glsl"

// 0 where no material's tileRotation is above 1. A literal, or the host's specialization constant.
#ifndef LICHEN_TILE_ROTATION
#define LICHEN_TILE_ROTATION 1
#endif

/// The number of evenly spaced angles that tiles take. 0 and 1: no rotation. Known at compile time
/// where no material rotates tiles.
uint lichenTileRotation(LichenMaterial material) {
  return bool(LICHEN_TILE_ROTATION) ? lichenTilingMaterial(material).tileRotation : 0u;
}

/// Whether rotation maps texels onto texels: half turns, and quarter turns of square exemplars.
/// Such tiles rotate about the origin, others about their vertices.
bool lichenRotationsKeepTexels(uint tileRotation, float tileAspect) {
  return tileRotation <= 2u || (tileRotation == 4u && tileAspect == 1.0);
}

/// The rotation of a vertex's tile: (cosine, sine) of its angle.
vec2 lichenTileRotationAt(uvec2 vertex, uint tileRotation, uint seedWord) {
  int steps = int(tileRotation);
  // Hashed again: both halves of the vertex's hash are the offset.
  uint hash = lichenPcg(lichenVertexHash(vertex.x, vertex.y, seedWord));
  int step = int(((hash >> 16u) * tileRotation) >> 16u);
  // The nearest quarter turn, which is exact, and the rest of up to an eighth of a turn, by
  // Taylor's series: a device's own sine may be 2^-11 off, a tenth of a texel.
  int quarter = int(floor(4.0 * float(step) / float(steps) + 0.5));
  const float kQuarterTurn = 1.5707963268;
  float x = kQuarterTurn * float(4 * step - quarter * steps) / float(steps);
  float xx = x * x;
  vec2 rotation = vec2(
      1.0 - xx * (1.0 / 2.0 - xx * (1.0 / 24.0 - xx * (1.0 / 720.0 - xx * (1.0 / 40320.0)))),
      x - x * xx * (1.0 / 6.0 - xx * (1.0 / 120.0 - xx * (1.0 / 5040.0 - xx * (1.0 / 362880.0)))));
  if ((quarter & 1) != 0)
    rotation = vec2(-rotation.y, rotation.x);
  return (quarter & 2) != 0 ? -rotation : rotation;
}

/// An offset on the plane [tiles] -> the offset in the exemplar of a tile rotated by `rotation`.
vec2 lichenRotated(vec2 offset, vec2 rotation, float tileAspect) {
  return vec2(rotation.x * offset.x - rotation.y * offset.y / tileAspect,
              rotation.x * offset.y + rotation.y * offset.x * tileAspect);
}

/// Slopes in the exemplar of a tile that is rotated by `rotation` -> slopes on the plane. Y points
/// up, against v.
vec2 lichenSlopesRotatedBack(vec2 slopes, vec2 rotation) {
  return vec2(rotation.x * slopes.x - rotation.y * slopes.y,
              rotation.x * slopes.y + rotation.y * slopes.x);
}

#endif
