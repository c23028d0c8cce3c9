// SPDX-License-Identifier: MIT
// A wave, and what a pixel leaves of it: the CPU twin of shaders_glsl/noise/wave.glsl.
#pragma once

#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {

/// lichenCosineOfTurns: cos(2 pi turns), within 1.1e-4.
inline float cosineOfTurns(float turns) {
  const float z = 0.25f - std::abs(turns - std::nearbyint(turns));
  const float square = z * z;
  return z * (6.2812805f + square * (-41.0952f + square * 73.5855f));
}

/// lichenCosineRetained: the amplitude that a footprint leaves of a cosine, for the square of the
/// cycles that it spans. The mean of a cosine over x cycles is sinc x, 1 - pi^2 x^2 / 6 near 0, as
/// this is.
inline float retainedAt(float squaredCycles) {
  constexpr float kSlope = 0.548311356f; // pi^2 / 18
  // Slanted pixels can be so long that the form is below 0 by rounding.
  const float left = std::clamp(1.0f - kSlope * squaredCycles, 0.0f, 1.0f);
  return left * left * left;
}

/// lichenBeyondTexel: a squared length [texels^2] -> what is averaged beyond a texel, over which
/// the exemplar has averaged already: 0 up to 1, and soon all of it.
inline float beyondTexel(float squared) {
  const float own = std::max(squared, 1.0f);
  return own - 1.0f / (own * own * own);
}

/// The squared cycles that a footprint spans of a frequency, as a quadratic form.
struct WaveFootprint {
  float xx = 0.0f, yy = 0.0f, xy = 0.0f;

  [[nodiscard]] float squaredCycles(float fx, float fy) const {
    return fx * (xx * fx + xy * fy) + yy * fy * fy;
  }
};

/// lichenWaveFootprint: beyondTexel() of the footprint's ellipse along both of its axes.
inline WaveFootprint waveFootprint(const TileFootprint& at, const shader::LichenNoise& noise) {
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

} // namespace lichen
