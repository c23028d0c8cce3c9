// SPDX-License-Identifier: MIT
// What a period does to rows of what repeats.
#pragma once

#include <string>
#include <vector>

namespace lichen::cli {

/// A note unless the period is whole numbers of exemplars, which alone keep the rows.
[[nodiscard]] std::vector<std::string> noteOnRows(double exemplarsX, double exemplarsY);

} // namespace lichen::cli
