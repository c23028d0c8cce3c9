// SPDX-License-Identifier: MIT
#include "period_note.h"

#include <fmt/format.h>

#include <cmath>

namespace lichen::cli {

std::vector<std::string> noteOnRows(double exemplarsX, double exemplarsY) {
  if (exemplarsX == std::round(exemplarsX) && exemplarsY == std::round(exemplarsY))
    return {};
  return {fmt::format("{:.4g} x {:.4g} exemplars break the rows of what repeats; whole numbers of "
                      "them keep the rows",
                      exemplarsX, exemplarsY)};
}

} // namespace lichen::cli
