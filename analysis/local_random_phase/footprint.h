// SPDX-License-Identifier: MIT
// What a pixel in the plane averages of a cosine: the CPU twin of lichenCosinesFootprint
// (shaders_glsl/noise/local_random_phase.glsl).
#pragma once

#include "cosine.h"
#include "cosine_vertices.h"

#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::local_random_phase {

/// The squared cycles that a footprint spans of a frequency, as a quadratic form.
struct Footprint {
  float xx = 0.0f, yy = 0.0f, xy = 0.0f;

  [[nodiscard]] float squaredCycles(float fx, float fy) const {
    return fx * (xx * fx + xy * fy) + yy * fy * fy;
  }

  /// Of the window at a vertex of an octave, by its mean square frequency.
  [[nodiscard]] float squaredCyclesOfWindow(int octave,
                                            const shader::LichenMaterial& material) const {
    const auto scale = float(std::ldexp(1.0, finerOctaves(octave, material)));
    const float columns = material.columnsPerTile * scale, rows = material.rowsPerTile * scale;
    return kWindowSpread *
           (xx * columns * columns + 0.75f * yy * rows * rows); // rows are sqrt(3) / 2 edges apart
  }
};

/// beyondTexel() of the footprint's ellipse along both of its axes.
inline Footprint footprintOf(const TileFootprint& at, const shader::LichenNoise& noise) {
  const std::array<float, 2> columns{at.dx[0] * noise.tileTexelsX, at.dy[0] * noise.tileTexelsX};
  const std::array<float, 2> rows{at.dx[1] * noise.tileTexelsY, at.dy[1] * noise.tileTexelsY};
  const float xx = columns[0] * columns[0] + columns[1] * columns[1];
  const float yy = rows[0] * rows[0] + rows[1] * rows[1];
  const float xy = columns[0] * rows[0] + columns[1] * rows[1];
  const float mean = 0.5f * (xx + yy), half = 0.5f * (xx - yy);
  const float apart = std::sqrt(half * half + xy * xy);
  const float longer = beyondTexel(mean + apart), shorter = beyondTexel(mean - apart);
  constexpr float kLeast = 1e-20f; // of a circle, whose axes are the same
  const float own = 0.5f * (longer + shorter);
  const float slope = 0.5f * (longer - shorter) / std::max(apart, kLeast);
  return {(own + slope * half) / (noise.tileTexelsX * noise.tileTexelsX),
          (own - slope * half) / (noise.tileTexelsY * noise.tileTexelsY),
          2.0f * slope * xy / (noise.tileTexelsX * noise.tileTexelsY)};
}

} // namespace lichen::local_random_phase
