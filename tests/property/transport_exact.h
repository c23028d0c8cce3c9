// SPDX-License-Identifier: MIT
// The oracle of the transport tests: the assignment problem solved exactly, and obviously.
#pragma once

#include <cstdint>
#include <span>
#include <transport/assignment.h>
#include <vector>

namespace lichen::test {

/// The bijection of least total squared distance, by the Hungarian method with potentials
/// [K55], [EK72] in double precision. O(n^3).
[[nodiscard]] std::vector<std::uint32_t> exactAssignment(std::span<const Point> source,
                                                         std::span<const Point> target);

/// Mean squared distance from one set to the other once both have mean 0: the cost that no
/// translation explains, against which errors are stated.
[[nodiscard]] double centredCost(std::span<const Point> source, std::span<const Point> target,
                                 std::span<const std::uint32_t> assignment);

} // namespace lichen::test
