// SPDX-License-Identifier: MIT
// Optimal transport between two point sets of equal size in the plane or in space.
#pragma once

#include "point.h"
#include "progress_part.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// How much work assign() does after the multiscale matching. The defaults cost about 6
/// microseconds per point on one core and leave the transport cost at most 0.1 % above the optimum
/// (docs/decisions/004-transport.md).
struct TransportOptions {
  int swapRounds = 4;  ///< rounds of two-opt in small blocks, several blockings per region
  int exactRounds = 1; ///< rounds of exact assignment in small blocks
  ProgressPart progress{};
};

/// Half of the time, and at most 0.4 % above the optimum.
inline constexpr TransportOptions kFastTransport{.swapRounds = 1, .exactRounds = 0};

/// Returns a bijection p with a small sum |source[i] - target[p[i]]|^2: near the optimum for every
/// distribution, exact in one dimension. Both sets have the same size N < 2^32 and finite
/// coordinates. Directions in which the sources do not vary are matched arbitrarily.
/// Matches coarse to fine, then exchanges targets inside blocks. Both steps work on the pair of
/// sets that precondition() makes, with equal covariances (docs/theory.md).
/// O(N log N) time; about 80 bytes per point beyond the arguments. The result does not depend on
/// the number of threads. Throws std::bad_alloc and Interrupted.
[[nodiscard]] std::vector<std::uint32_t> assign(std::span<const Point> source,
                                                std::span<const Point> target,
                                                const TransportOptions& options);

/// Like assign(), but improves the bijection `start`.
[[nodiscard]] std::vector<std::uint32_t> improveAssignment(std::span<const Point> source,
                                                           std::span<const Point> target,
                                                           std::vector<std::uint32_t> start,
                                                           const TransportOptions& options);

} // namespace lichen::transport
