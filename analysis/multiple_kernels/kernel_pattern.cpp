// SPDX-License-Identifier: MIT
// A point and its footprint -> the sum of a pattern's cosines. Steps and names follow
// shaders_glsl/noise/kernel_pattern.glsl.
#include "kernel_pattern.h"

#include <algorithm>
#include <cmath>

namespace lichen::multiple_kernels {

PatternSum patternAt(std::span<const PatternCosine> cosines, const KernelPlace& place,
                     const WaveFootprint& footprint, const shader::LichenMaterial& material) {
  const std::array<float, 2> period{material.periodTilesX, material.periodTilesY};
  std::array<float, 2> position{}, repeats{1.0f, 1.0f};
  for (std::size_t k = 0; k < 2; ++k) {
    const bool isPeriodic = material.periodRows != 0;
    position[k] = place.inside[k] * (isPeriodic ? period[k] : float(kKernelTiles));
    if (!isPeriodic)
      position[k] -= std::floor(position[k]);
    else
      repeats[k] = std::max(std::floor(period[k] + 0.5f), 1.0f) / period[k];
  }
  PatternSum sum;
  for (const PatternCosine& cosine : cosines) {
    const float fx = repeats[0] * cosine.frequency[0], fy = repeats[1] * cosine.frequency[1];
    const float turns = fx * position[0] + fy * position[1];
    const float wave = cosineOfTurns(turns), sine = cosineOfTurns(turns - 0.25f);
    const float retained = retainedAt(footprint.squaredCycles(fx, fy));
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [a, b] = cosine.waves[c];
      const float own = 0.5f * (a * a + b * b);
      sum.gaussian[c] += retained * (wave * a + sine * b);
      sum.squares += own;
      sum.lost += own * (1.0f - retained * retained);
      const float turned = 6.28318531f * retained * (wave * b - sine * a);
      sum.alongX[c] += fx * turned;
      sum.alongY[c] += fy * turned;
    }
  }
  return sum;
}

} // namespace lichen::multiple_kernels
