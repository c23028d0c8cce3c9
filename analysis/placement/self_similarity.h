// SPDX-License-Identifier: MIT
// How highly a picture correlates with itself, moved without wrapping around, and how badly two
// lines of it fit together that become opposite borders of a tile.
#pragma once

#include "exemplar/planes.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lichen::placement {

/// How highly a picture correlates with itself, moved by (x, y), less than its sides in either
/// direction.
struct SelfCorrelation {
  int width = 0, height = 0; ///< twice the picture's
  std::vector<float> values; ///< [y * width + x], negative x and y from the end

  [[nodiscard]] float at(int x, int y) const {
    x = x < 0 ? x + width : x;
    y = y < 0 ? y + height : y;
    return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

/// The products of all pairs of values, over the root of the energies of both parts that overlap; 0
/// where hardly anything overlaps. For several channels, the sum. O(N log N) in the pixels. Throws
/// std::bad_alloc.
[[nodiscard]] SelfCorrelation selfCorrelation(const exemplar::ImageLevel& image);

/// Keeps a reference to the image.
class BorderMisfit {
public:
  explicit BorderMisfit(const exemplar::ImageLevel& image);
  explicit BorderMisfit(exemplar::ImageLevel&&) = delete;

  /// The mean squared difference of two lines, over the difference of unrelated pixels: about 0.1
  /// where joints meet joints, 0.14 to 1.4 where cells are cut, 0 in an image with hardly more
  /// variance than 8-bit rounding. One line goes from `from` along `side`, the other is `apart`
  /// from it; both are inside of the image, whose pixels have their corners at whole coordinates.
  /// Each pixel is compared with the most similar of five across the other line, as far as they are
  /// inside of the image, since joints wind. O(N) in the pixels along the line.
  [[nodiscard]] double between(const std::array<double, 2>& from, const std::array<double, 2>& side,
                               const std::array<double, 2>& apart) const;
  /// Whether opposite borders of the image look alike: the left and the right one for the axis 0,
  /// the upper and the lower one for 1. They do where they lie in joints, or cut cells of one
  /// colour. O(N) in the pixels along them.
  [[nodiscard]] bool bordersLookAlike(std::size_t axis) const;

private:
  const exemplar::ImageLevel& image_;
  double unrelated_ = 0.0; ///< twice the variance
};

} // namespace lichen::placement
