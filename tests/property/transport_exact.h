// SPDX-License-Identifier: MIT
// The oracle of the transport tests: an exact, straightforward solver of the assignment problem.
#pragma once

#include <cstdint>
#include <span>
#include <transport/assignment.h>
#include <vector>

namespace lichen::test {

/// Returns the bijection of least total squared distance, by the Hungarian method with potentials
/// [K55], [EK72], in double precision. O(n^3).
[[nodiscard]] std::vector<std::uint32_t> exactAssignment(std::span<const Point> source,
                                                         std::span<const Point> target);

/// Returns the mean squared distance from source i to target assignment[i]; 0 for empty sets.
[[nodiscard]] double transportCost(std::span<const Point> source, std::span<const Point> target,
                                   std::span<const std::uint32_t> assignment);

/// Mean squared distance between the two sets after both are moved to mean 0. This is the cost that
/// no translation explains; errors are relative to it.
[[nodiscard]] double centredCost(std::span<const Point> source, std::span<const Point> target,
                                 std::span<const std::uint32_t> assignment);

} // namespace lichen::test
