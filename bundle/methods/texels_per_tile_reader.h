// SPDX-License-Identifier: MIT
// Reads the member "texelsPerTile" of a noise: the size of its exemplar.
#pragma once

#include "extension_reader.h"

#include <array>
#include <optional>

namespace lichen {

/// The member "texelsPerTile", two whole numbers in [1, kMaxTableSide]. Nothing if it is faulty.
[[nodiscard]] std::optional<std::array<int, 2>> readTexelsPerTile(ObjectReader& reader);

} // namespace lichen
