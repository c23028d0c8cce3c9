// SPDX-License-Identifier: MIT
// Hashed values at the corners of cubes, interpolated; see space_noise.h.
#include "space_noise.h"

#include <lichen/lattice.h>

#include <cmath>

namespace lichen::exemplars {

float spaceNoise(const std::array<float, 3>& position, std::uint32_t seed) {
  std::array<float, 3> floors{}, weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    floors[k] = std::floor(position[k]);
    const float f = position[k] - floors[k];
    weights[k] = f * f * (3.0f - 2.0f * f);
  }
  float sum = 0.0f;
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    std::array<std::uint32_t, 3> cell{};
    float weight = 1.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t step = corner >> k & 1u;
      cell[k] = std::uint32_t(std::int32_t(floors[k])) + step;
      weight *= step != 0 ? weights[k] : 1.0f - weights[k];
    }
    constexpr float kStep = 1.0f / 32768.0f;
    const std::uint32_t hash = pcg3d({cell[0], cell[1], pcg(cell[2] + pcg(seed))})[0];
    sum += weight * (float(hash >> 16) * kStep - 1.0f);
  }
  return sum;
}

} // namespace lichen::exemplars
