// SPDX-License-Identifier: MIT
// Reads the size of the exemplar of a noise whose images do not have it.
#pragma once

#include "extension_reader.h"

#include <array>
#include <optional>

namespace lichen {

/// The member "texelsPerTile", two whole numbers in [1, kMaxTableSide]. Nothing if it is faulty.
[[nodiscard]] std::optional<std::array<int, 2>> readTexelsPerTile(ObjectReader& reader);

} // namespace lichen
