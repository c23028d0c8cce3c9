// SPDX-License-Identifier: MIT
// Cells, shifts -> the shifts after which edges lie on edges. docs/decisions/012-quilting.md says
// how the constants were chosen.
#include "fitting_shifts.h"

#include "placement/near_periods.h"

#include <algorithm>
#include <cstddef>

namespace lichen::quilting {
namespace {

/// 1 minus the correlation of edges with those a shift further: 0 if they coincide, about 1 if they
/// are unrelated.
double missOf(const CellField& cells, const std::array<double, 2>& shift) {
  const int shiftX = placement::pixelsOf(shift[0], cells.width);
  const int shiftY = placement::pixelsOf(shift[1], cells.height);
  const double count = double(cells.edges.size());
  double sum = 0.0, squares = 0.0, products = 0.0;
  std::size_t i = 0;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x, ++i) {
      const int column = (x + shiftX) % cells.width, row = (y + shiftY) % cells.height;
      const auto j = std::size_t(row) * std::size_t(cells.width) + std::size_t(column);
      const double own = double(cells.edges[i]);
      sum += own;
      squares += own * own;
      products += own * double(cells.edges[j]);
    }
  const double variance = squares - sum * sum / count;
  return variance > 0.0 ? (squares - products) / variance : 0.0;
}

} // namespace

FittingShifts fittingShifts(const CellField& cells, std::span<const std::array<double, 2>> shifts) {
  constexpr std::size_t kFewest = 9;  // fewer would repeat visibly
  constexpr double kAlike = 0.08;     // shifts whose misses differ by less fit equally well
  std::vector<double> misses, sorted; // the latter without the miss of no shift
  for (const std::array<double, 2>& shift : shifts) {
    misses.push_back(missOf(cells, shift));
    if (shift[0] != 0.0 || shift[1] != 0.0)
      sorted.push_back(misses.back());
  }
  if (sorted.empty())
    return {{shifts.begin(), shifts.end()}};
  std::ranges::sort(sorted);
  const double most = std::max({sorted.front() + kAlike, 0.5 * (sorted.front() + sorted.back()),
                                sorted[std::min(kFewest - 1, sorted.size()) - 1]});
  FittingShifts fitting{{}, sorted.front()};
  for (std::size_t k = 0; k < shifts.size(); ++k)
    if (misses[k] <= most)
      fitting.shifts.push_back(shifts[k]);
  return fitting;
}

} // namespace lichen::quilting
