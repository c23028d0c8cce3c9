// SPDX-License-Identifier: MIT
// Cells, shifts -> the shifts after which cells lie on cells. docs/decisions/039-quilting.md says
// how the constants were chosen.
#include "fitting_shifts.h"

#include "placement/near_periods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace lichen::quilting {
namespace {

/// How far cells miss cells after a shift: the mean squared difference of the vectors to their
/// centres, over that of unrelated cells. About 0 to 1.
double missOf(const CellField& cells, const std::array<double, 2>& shift) {
  const int shiftX = placement::pixelsOf(shift[0], cells.width);
  const int shiftY = placement::pixelsOf(shift[1], cells.height);
  double differences = 0.0, squares = 0.0;
  std::size_t i = 0;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x, ++i) {
      const int column = (x + shiftX) % cells.width, row = (y + shiftY) % cells.height;
      const auto j = std::size_t(row) * std::size_t(cells.width) + std::size_t(column);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double own = double(cells.toCentre[i][axis]);
        differences += std::pow(double(cells.toCentre[j][axis]) - own, 2.0);
        squares += own * own;
      }
    }
  return squares > 0.0 ? differences / (2.0 * squares) : 0.0;
}

} // namespace

FittingShifts fittingShifts(const CellField& cells, std::span<const std::array<double, 2>> shifts) {
  constexpr std::size_t kFewest = 9; // fewer would repeat visibly
  std::vector<double> misses;
  double least = 1.0;
  for (const std::array<double, 2>& shift : shifts) {
    misses.push_back(missOf(cells, shift));
    if (shift[0] != 0.0 || shift[1] != 0.0)
      least = std::min(least, misses.back());
  }
  double most = 0.5 * (least + 1.0); // half way from the best to unrelated cells
  std::vector<double> sorted = misses;
  std::ranges::sort(sorted);
  if (!sorted.empty())
    most = std::max(most, sorted[std::min(kFewest, sorted.size()) - 1]);
  std::vector<std::array<double, 2>> fitting;
  for (std::size_t k = 0; k < shifts.size(); ++k)
    if (misses[k] <= most)
      fitting.push_back(shifts[k]);
  return {std::move(fitting), least};
}

} // namespace lichen::quilting
