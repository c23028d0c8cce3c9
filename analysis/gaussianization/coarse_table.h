// SPDX-License-Identifier: MIT
// Fits a table with fewer cells to a table.
#pragma once

#include "inverse_table.h"

namespace lichen::gaussianization {

/// The table of `side` cells on each axis whose lookups differ least, in the mean square, from
/// lookups of `table`, at Gaussian values of standard deviation `amplitude` / 6 about 1/2,
/// amplitude in (0, 1]. Throws std::bad_alloc.
[[nodiscard]] InverseTable coarser(const InverseTable& table, int side, double amplitude);

} // namespace lichen::gaussianization
