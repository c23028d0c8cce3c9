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
  std::vector<float> amplitudes;
};

} // namespace lichen
