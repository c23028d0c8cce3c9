// SPDX-License-Identifier: MIT
// Footprints at which oracles are compared.
#pragma once

#include <lichen/noise_evaluator.h>

#include <cmath>
#include <random>
#include <vector>

namespace lichen::test {

/// Within a tile around the origin, with any normal, a third of them in a plane of two axes and
/// some along an axis. Pixels have sides from an eighth of a texel, of 64 in a tile, to a tile.
inline std::vector<TriplanarFootprint> oracleFootprints(std::size_t count) {
  std::mt19937 generator(5u);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f), level(-9.0f, 0.0f);
  std::normal_distribution<float> gaussian;
  std::vector<TriplanarFootprint> all(count);
  for (std::size_t k = 0; k < count; ++k) {
    const float side = std::exp2(level(generator));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all[k].position[axis] = place(generator);
      all[k].normal[axis] = gaussian(generator);
      all[k].dx[axis] = side * gaussian(generator);
      all[k].dy[axis] = 0.5f * side * gaussian(generator);
    }
    if (k % 3 == 0)
      all[k].normal[k % 9 / 3] = 0.0f;
    if (k % 18 == 0)
      all[k].normal[1] = 0.0f;
  }
  return all;
}

/// In a plane.
inline TileFootprint onTiles(const TriplanarFootprint& at) {
  return {{at.position[0], at.position[1]}, {at.dx[0], at.dx[1]}, {at.dy[0], at.dy[1]}};
}

} // namespace lichen::test
