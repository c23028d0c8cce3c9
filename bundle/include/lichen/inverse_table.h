// SPDX-License-Identifier: MIT
// The inverse table of a map: Gaussian values -> stored values, by every method that has one.
#pragma once

#include <cstdint>

namespace lichen {

/// Sides of an inverse table: powers of two in this range. It has at most kMostTableLevels mip
/// levels, and none of one cell.
inline constexpr std::uint32_t kLeastTableSide = 4, kMostTableSide = 256;
inline constexpr std::uint32_t kMostTableLevels = 5;

} // namespace lichen
