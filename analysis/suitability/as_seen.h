// SPDX-License-Identifier: MIT
// What of a map an eye sees: of heights, the light on their slopes.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// The slopes of a height map, as its normal map has them, by central differences of the heights
/// themselves, decoded where they are stored as log2(1 + height); of the relief that
/// kReliefDeviation tells, since heights state no scale. `periodic`: whether differences go over
/// opposite borders; else those at a border are one-sided. Zeros for a constant height. Throws
/// std::bad_alloc.
[[nodiscard]] MapExemplar slopesOfHeight(const MapExemplar& map, bool periodic);

} // namespace lichen::suitability
