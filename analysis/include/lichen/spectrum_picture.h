// SPDX-License-Identifier: MIT
// A spectrum that the user gives in place of the exemplar's.
#pragma once

#include <vector>

namespace lichen {

/// Amplitudes at whole numbers of cycles per tile, row by row: column x and row y have the
/// frequency (x - width / 2, y - height / 2), rounded down. Finite and not negative. Amplitudes of
/// a frequency and its negative are averaged in the square; frequency 0 and those that the
/// exemplar's pixels cannot hold do not count.
struct SpectrumPicture {
  int width = 0, height = 0;
  std::vector<float> amplitudes; ///< channels * width * height
  /// 1, or 3 of one pixel after the other: of the red, green and blue of colour maps. Other maps
  /// take the root of the mean square.
  int channels = 1;
};

} // namespace lichen
