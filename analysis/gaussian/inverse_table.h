// SPDX-License-Identifier: MIT
// The inverse transformation T^-1 as a table over U in [0, 1]^D: [HN18] section 4.3.
#pragma once

#include "exemplar/color_space.h"
#include "gaussianize.h"

#include <array>
#include <span>
#include <vector>

namespace lichen::gaussian {

/// Cells per axis of a table of D = 1, 2, 3 dimensions.
inline constexpr std::array<int, 3> kTableSide{256, 64, 32};

/// side^dimensions cells of `channels` values, first axis fastest. Cell i of an axis covers U in
/// [i, i + 1) / side, and its value applies at its centre. A lookup interpolates linearly between
/// centres and is constant beyond the outermost.
struct InverseTable {
  int dimensions = 1;
  int side = kTableSide[0];
  int channels = 3;
  std::vector<float> values;

  [[nodiscard]] std::size_t cellCount() const { return values.size() / std::size_t(channels); }
};

/// The Gaussian values at the centres of an axis's cells.
[[nodiscard]] std::vector<float> axisMiddles(int side);
/// The same for all cells, first axis fastest; unused coordinates are 0.
[[nodiscard]] std::vector<Point> cellMiddles(int dimensions, int side);

/// Mean and covariance of a lookup at uniformly distributed U, in closed form.
[[nodiscard]] exemplar::Moments interpolatedMoments(const InverseTable& table);

/// The content of a cell in a table of two dimensions (docs/decisions/002-inverse-tables.md).
enum class CellValue {
  onePixel, ///< one pixel's value, which preserves the histogram
  mean,     ///< the mean of its pixels, about four per cell, which keeps neighbours similar
};

/// Fits a table to the pairs (gaussian.matched[i], decoded[i]). `decoded` holds what the
/// table is to hold for the exemplar's values (roots of light for colours), `points` the same in
/// the transport's space. In one dimension a cell is the mean of its quantile interval. In more,
/// unless `value` is CellValue::mean, a second transport from the pixels to the cells' centres
/// starts from the first one. The looked-up values then have the exemplar's mean and covariance, as
/// far as its range of values allows.
[[nodiscard]] InverseTable fitInverseTable(const Gaussianized& gaussian,
                                           std::span<const Point> points,
                                           std::span<const float> decoded, int channels,
                                           const transport::TransportOptions& options,
                                           CellValue value = CellValue::onePixel);

} // namespace lichen::gaussian
