// SPDX-License-Identifier: MIT
// How badly two lines of a picture fit together that become opposite borders of a tile.
#pragma once

#include "exemplar/area_average.h"

#include <array>

namespace lichen::placement {

/// Keeps a reference to the image.
class BorderMisfit {
public:
  explicit BorderMisfit(const exemplar::ImageLevel& image);

  /// The mean squared difference of two lines, over that of unrelated pixels: 0 where joints meet
  /// joints, about 1 where cells are cut. One line goes from `from` along `side`, the other is
  /// `apart` from it; both are inside of the image, whose pixels have their corners at whole
  /// coordinates. Each pixel is compared with the most similar of five across the other line, since
  /// joints wind. O(N) in the pixels along the line.
  [[nodiscard]] double between(const std::array<double, 2>& from, const std::array<double, 2>& side,
                               const std::array<double, 2>& apart) const;

private:
  const exemplar::ImageLevel& image_;
  double unrelated_ = 0.0; ///< twice the variance
};

} // namespace lichen::placement
