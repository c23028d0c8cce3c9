// SPDX-License-Identifier: MIT
// Pictures of the table that decodes a map's Gaussian values, for every method that has one.
#pragma once

#include "method_report.h"

namespace lichen {

/// `levels`, each with its `picture`, `slices` and `lost` variance; null without a table.
[[nodiscard]] Result<nlohmann::ordered_json>
inverseTablePictures(const Bundle& bundle, const NoiseMap& map, const MapLook& look);

} // namespace lichen
