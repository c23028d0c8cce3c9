// SPDX-License-Identifier: MIT
// Optimal transport between two point sets of equal size in the plane or in space.
#pragma once

#include "point.h"
#include "progress_part.h"

#include <lichen/transport.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// How much work assign() does beyond the multiscale matching. The defaults cost about 6
/// microseconds a point of one core and leave the transport cost at most a tenth of a per cent
/// above the optimum (docs/decisions/008-multiscale-transport.md).
struct TransportOptions {
  int swapRounds = 4;  ///< rounds of two-opt inside small blocks, several times in regions
  int exactRounds = 1; ///< rounds of exact assignment inside blocks of `blockSize`
  int blockSize = 48;  ///< [2, 256] points
  std::uint64_t seed = 1;
  ProgressPart progress{};
};

[[nodiscard]] TransportOptions optionsFor(TransportEffort effort);

/// A bijection p that makes sum |source[i] - target[p[i]]|^2 small: near the optimum for every
/// distribution, exact in one dimension. Both sets have the same size N < 2^32 and finite
/// coordinates. Directions in which the sources do not vary are matched arbitrarily.
/// O(N log N) time, about 80 bytes a point beyond the arguments. The same result for any number of
/// threads. Throws std::bad_alloc and Interrupted.
/// Multiscale matching, then exchanges inside blocks, on the pair of sets made alike by the
/// closed-form map between their covariances (docs/theory.md).
[[nodiscard]] std::vector<std::uint32_t> assign(std::span<const Point> source,
                                                std::span<const Point> target,
                                                const TransportOptions& options);

/// As above, improving the bijection `start` instead of making one.
[[nodiscard]] std::vector<std::uint32_t> improveAssignment(std::span<const Point> source,
                                                           std::span<const Point> target,
                                                           std::vector<std::uint32_t> start,
                                                           const TransportOptions& options);

/// Mean of |source[i] - target[p[i]]|^2.
[[nodiscard]] double transportCost(std::span<const Point> source, std::span<const Point> target,
                                   std::span<const std::uint32_t> assignment);

} // namespace lichen::transport
