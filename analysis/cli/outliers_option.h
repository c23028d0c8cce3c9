// SPDX-License-Identifier: MIT
// What the exemplar shows only once: filled, or named with the crop that leaves it out.
#pragma once

#include "command.h"

#include <lichen/bundle.h>
#include <lichen/exemplar.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lichen::cli {

/// What happens to parts of an exemplar that occur once.
struct OutlierUse {
  bool keeps = false;                               ///< --keep-outliers
  std::optional<std::vector<FilledPlace>> recorded; ///< to fill exactly these
};

/// The part of the largest file that became the exemplar: column, row, width and height.
using PhotographPart = std::array<double, 4>;

/// Fills outliers of the maps, if the first is a base colour and none is opacity, whose shape is
/// the material; adds to `notes` where they were. `borders` belong to the set. Without a `part`,
/// places are in pixels of the first map. Returns what was filled.
[[nodiscard]] Result<std::vector<FilledPlace>>
applyOutliers(std::vector<MapExemplar>& maps, const OutlierUse& use, Periodic borders,
              const std::optional<PhotographPart>& part, const SharedOptions& options,
              std::vector<std::string>& notes);

} // namespace lichen::cli
