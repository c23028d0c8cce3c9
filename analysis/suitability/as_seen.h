// SPDX-License-Identifier: MIT
// The part of a map that an eye sees: for heights, the light on their slopes.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// The slopes of a height map, as its normal map would have them, by central differences of the
/// heights. Decodes heights stored as log2(1 + height) first. Heights have no stated scale, so
/// kReliefDeviation sets the relief. If `periodic`, differences wrap around the borders; otherwise
/// they are one-sided there. Returns zeros for a constant height. Throws std::bad_alloc.
[[nodiscard]] MapExemplar slopesOfHeight(const MapExemplar& map, bool periodic);

} // namespace lichen::suitability
