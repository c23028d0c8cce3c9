// SPDX-License-Identifier: MIT
// Which near-periods of an exemplar bring edges onto edges.
#pragma once

#include "cells.h"

#include <array>
#include <span>
#include <vector>

namespace lichen::quilting {

/// Between knits and cobbles: docs/decisions/012-quilting.md.
inline constexpr double kCloseMiss = 0.52;

struct FittingShifts {
  std::vector<std::array<double, 2>> shifts; ///< [tiles]
  /// How far edges miss edges after the best of them: 0 not at all, 1 like any shift.
  double miss = 1.0;

  /// Whether edges fit closely, as with bricks of one size, or loosely, as with cobbles.
  [[nodiscard]] bool isClose() const { return miss < kCloseMiss; }
};

/// The shifts after which edges are where they were, in their order. Values alone do not say so:
/// rows of boards are alike after any shift along them, but their ends are not. `shifts` are those
/// of NearPeriods, the first of them 0. At least nine, the best, if there are as many. Source:
/// docs/decisions/012-quilting.md.
[[nodiscard]] FittingShifts fittingShifts(const CellField& cells,
                                          std::span<const std::array<double, 2>> shifts);

} // namespace lichen::quilting
