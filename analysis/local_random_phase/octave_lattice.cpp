// SPDX-License-Identifier: MIT
// The size of the lattices' cells.
#include "octave_lattice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::local_random_phase {

std::array<int, 2> cellsOfOctave0(int texelsX, int texelsY) {
  // 7 columns and 8 rows of a square tile are equilateral to 1 %.
  constexpr double kColumns = 7.0, kHalfRows = 4.0;
  const double shorter = std::min(texelsX, texelsY);
  const auto cells = [&](double ofSquare, int side) {
    return std::clamp(int(std::lround(ofSquare * side / shorter)), 1, kMostOctaveCells / 2);
  };
  return {cells(kColumns, texelsX), 2 * cells(kHalfRows, texelsY)};
}

std::array<double, 2> edgesOfOctave0(int columns, int rows) {
  return {kOctaveTiles / double(columns), 2.0 / std::numbers::sqrt3 * kOctaveTiles / double(rows)};
}

} // namespace lichen::local_random_phase
