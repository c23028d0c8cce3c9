// SPDX-License-Identifier: MIT
// One random binary-partition matching of two point sets.
#pragma once

#include "point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Halves both sets along the same random direction, and matches the halves likewise down to
/// single points [BSP-OT, Genest et al. 2025, section 4]. Returns p with source i matched to
/// target p[i]. Deterministic in `seed` and independent of the number of threads.
[[nodiscard]] std::vector<std::uint32_t> partitionTreeMatching(std::span<const Point> source,
                                                               std::span<const Point> target,
                                                               std::uint64_t seed);

} // namespace lichen::transport
