// SPDX-License-Identifier: MIT
// Regular patterns as sums of cosines, from pictures, splines and waves.
#pragma once

#include <lichen/image.h>

#include <span>
#include <vector>

namespace lichen {

/// amplitude cos(2 pi (frequency . x + phase)), x in tiles.
struct PatternWave {
  int u = 0, v = 0; ///< frequency along x and y [cycles / tile]
  double amplitude = 1.0;
  double phase = 0.0; ///< [turns]
};

/// The same waves, each frequency once, with positive amplitudes, the largest first; at most
/// `cosines`. Throws std::bad_alloc.
[[nodiscard]] std::vector<PatternWave> strongestWaves(std::span<const PatternWave> waves,
                                                      int cosines);

/// The waves of a picture that repeats `repeats` times along each axis of a tile, without its mean:
/// the waves with the `cosines` largest amplitudes of its luminance codes. Throws std::bad_alloc.
[[nodiscard]] std::vector<PatternWave> patternOf(const SrgbImage& picture, int repeats,
                                                 int cosines);

/// The waves of a periodic cubic B-spline along the direction (u, v), as often in a tile, with
/// equally spaced control points: harmonics up to as many as there are points.
[[nodiscard]] std::vector<PatternWave> patternOfSpline(int u, int v,
                                                       std::span<const double> points);

} // namespace lichen
