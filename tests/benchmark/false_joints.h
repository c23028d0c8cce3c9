// SPDX-License-Identifier: MIT
// Joints where a quilting shows the inside of a cell, such as mortar across a brick.
#pragma once

#include <lichen/bundle.h>

#include <cstdint>
#include <vector>

namespace lichen::bench {

inline constexpr int kInnerPixels = 3;

struct FalseJoints {
  /// The share of the pixels of all cells that the result shows which belongs to a joint. The
  /// result shows a cell where more than half of the cell's pixels are of one tile; pixels of the
  /// cell count wherever the exemplar has them, even if the result shows another tile there. A
  /// pixel belongs to a joint if at least half of the weight of its tiles does.
  double share = 0.0;
  double inner = 0.0;      ///< the same of pixels at least kInnerPixels inside their cell
  double shownCells = 0.0; ///< the pixels of the cells shown, over the result's
};

/// Measures a result of `tilesPerSide` x `tilesPerSide` exemplars. The exemplar has `side` x `side`
/// pixels, its borders fit together, and `cells` has its cells in the form of
/// StructuredPicture::cells.
[[nodiscard]] FalseJoints falseJoints(const Bundle& quilting, const std::vector<int>& cells,
                                      int side, int tilesPerSide, std::uint32_t seed);

} // namespace lichen::bench
