// SPDX-License-Identifier: MIT
// A lattice that repeats: vertices -> the vertices of one period, and the whole periods between.
#ifndef LICHEN_PERIODIC_LATTICE_GLSL
#define LICHEN_PERIODIC_LATTICE_GLSL

#include "../interface/lichen_interface.h"

// 0 where no material has a periodic lattice. A literal, or the host's specialization constant.
#ifndef LICHEN_PERIODIC_LATTICE
#define LICHEN_PERIODIC_LATTICE 1
#endif

/// floor(value / period), for |value| < 2^20 and period > 0. Integer division is slow on many
/// devices. (value + 1/2) / period is at least 1 / (2 period) away from any integer, more than the
/// rounding of its product with the reciprocal.
int lichenFloorDivide(int value, int period) {
  return int(floor((float(value) + 0.5) * (1.0 / float(period))));
}

/// Reduces a vertex to one period and returns the whole periods taken away [tiles]; an infinite
/// lattice is left alone. The cells of a periodic one are near the origin, which the host reduces
/// to one period of at most 65,536 tiles: |i|, |j| < 2^20.
vec2 lichenReduceToPeriod(LICHEN_INOUT(uvec2) vertex, LichenMaterial material) {
  if (!bool(LICHEN_PERIODIC_LATTICE) || material.periodRows == 0)
    return vec2(0.0);
  ivec2 near = ivec2(vertex);
  int rows = lichenFloorDivide(near.y, material.periodRows);
  near += rows * ivec2(material.periodRows / 2, -material.periodRows);
  int columns = lichenFloorDivide(near.x, material.periodColumns);
  near.x -= columns * material.periodColumns;
  vertex = uvec2(near);
  return vec2(float(columns) * material.periodTilesX, float(rows) * material.periodTilesY);
}

#endif
