// SPDX-License-Identifier: MIT
// Splits the half plane of frequencies into rectangles of nearly constant power.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lichen::random_phase {

/// Powers at integer frequencies of a half plane, in cycles per tile: (u, v), u in [0, columns), v
/// in [-rows / 2, rows / 2], is values[(v + rows / 2) * columns + u]. `rows` is odd. Column 0
/// counts half, as its mirror is in the half plane too; frequency (0, 0) does not count.
struct PowerPlane {
  int columns = 0;
  int rows = 0;
  std::vector<double> values;

  [[nodiscard]] double at(int u, int v) const {
    return values[std::size_t(v + rows / 2) * std::size_t(columns) + std::size_t(u)];
  }
};

/// The texels along x and y of the tile that has these frequencies; an odd side counts one more.
[[nodiscard]] inline std::array<double, 2> texelsOf(const PowerPlane& plane) {
  return {2.0 * plane.columns, double(plane.rows + 1)};
}

/// Each frequency averaged with its neighbours, by 1 2 1 along both axes, (0, 0) left out: the
/// power of one image fluctuates about the power of its texture by as much as its size.
[[nodiscard]] PowerPlane smoothed(const PowerPlane& power);

/// Frequencies u in [left, right), v in [top, bottom).
struct FrequencyBox {
  int left = 0, right = 0, top = 0, bottom = 0;

  /// The continuous rectangle: each integer frequency stands for the unit square around it, of
  /// which column 0 has the right half in the half plane.
  [[nodiscard]] double low() const { return left == 0 ? 0.0 : left - 0.5; }
  [[nodiscard]] double high() const { return right - 0.5; }
  [[nodiscard]] double lowRow() const { return top - 0.5; }
  [[nodiscard]] double highRow() const { return bottom - 0.5; }
  [[nodiscard]] double width() const { return high() - low(); }
  [[nodiscard]] double height() const { return highRow() - lowRow(); }
};

/// Splits the plane `count` - 1 times, each time where it reduces the error of a constant power in
/// every box most; fewer times if no box varies. The error counts both absolute differences, which
/// the autocovariance shows, and relative ones, which decibels show. O(count (columns + rows))
/// after one pass over the plane. Deterministic.
[[nodiscard]] std::vector<FrequencyBox> boxesOfEqualPower(const PowerPlane& power,
                                                          std::size_t count);

/// Halves the plane's power `count` - 1 times, each time the power of the strongest box, across its
/// longer side, and shrinks each box to where its power is; fewer times if none can be halved. For
/// spectra that are 0 nearly everywhere, as rings and bands are: a box with holes would spread
/// power over them. O(count columns rows). Deterministic.
[[nodiscard]] std::vector<FrequencyBox> boxesAroundPower(const PowerPlane& power,
                                                         std::size_t count);

} // namespace lichen::random_phase
