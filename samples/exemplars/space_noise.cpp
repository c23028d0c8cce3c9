// SPDX-License-Identifier: MIT
// Hashed values at the corners of cubes or squares, interpolated; see space_noise.h.
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

float planeNoise(const std::array<float, 2>& position, const std::array<int, 2>& repeat,
                 std::uint32_t seed) {
  std::array<std::array<std::uint32_t, 2>, 2> cells{}; // by axis, then by corner
  std::array<float, 2> weights{};
  for (std::size_t k = 0; k < 2; ++k) {
    const float floor = std::floor(position[k]), f = position[k] - floor;
    weights[k] = f * f * (3.0f - 2.0f * f);
    for (int step = 0; step < 2; ++step) {
      const int cell = int(floor) + step, count = repeat[k];
      cells[k][std::size_t(step)] =
          std::uint32_t(count == 0 ? cell : (cell % count + count) % count);
    }
  }
  const std::uint32_t seedWord = pcg(seed);
  const auto valueAt = [&](std::size_t i, std::size_t j) {
    return float(vertexHash(cells[0][i], cells[1][j], seedWord) >> 16) / 32768.0f - 1.0f;
  };
  const auto rowAt = [&](std::size_t j) {
    return valueAt(0, j) + weights[0] * (valueAt(1, j) - valueAt(0, j));
  };
  const float low = rowAt(0);
  return low + weights[1] * (rowAt(1) - low);
}

} // namespace lichen::exemplars
