// SPDX-License-Identifier: MIT
// Exact assignment of a few points, starting from a nearly optimal one.
#pragma once

#include <lichen/transport.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Cancels negative cycles until none is left [Klein 1967], found by Bellman-Ford sweeps over the
/// dense exchange graph: where the start is nearly optimal, as after two-opt, few sweeps do.
/// Holds its working memory, so that one object solves many problems; not thread-safe.
class CycleCanceling {
public:
  /// Reorders `target` (and `targetIndex` with it) so that sum <source[i], target[i]> is largest,
  /// up to rounding. The spans have one size n; O(n^2) for each sweep.
  void solve(std::span<const Point> source, std::span<Point> target,
             std::span<std::uint32_t> targetIndex);

private:
  void fillExchangeCosts(std::span<const Point> source, std::span<const Point> target);
  [[nodiscard]] bool findCycle();
  [[nodiscard]] float cycleCost() const;

  std::size_t stride_ = 0;
  std::vector<float> exchange_;
  std::vector<float> distance_;
  std::vector<std::int32_t> parent_;
  std::vector<std::uint32_t> mark_;
  std::vector<std::uint32_t> cycle_;
};

} // namespace lichen::transport
