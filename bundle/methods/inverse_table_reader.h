// SPDX-License-Identifier: MIT
// Reads and checks a map's inverse table, for every method that has one.
#pragma once

#include "extension_reader.h"

#include <cstddef>
#include <optional>

namespace lichen {

/// The members "dimensions" and "inverseTable" of a map.
struct InverseTableMembers {
  int dimensions = 1;
  std::optional<std::size_t> table;
};

/// Reads both, and checks them against the map's channels, covariance and encoding, and the table
/// against them.
[[nodiscard]] InverseTableMembers readInverseTable(ObjectReader& reader, const NoiseMap& map,
                                                   const Tables& tables);

} // namespace lichen
