// SPDX-License-Identifier: MIT
// Exact assignment of a few points, starting from a nearly optimal one.
#pragma once

#include "point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Cancels negative cycles until none is left [K67], found by Bellman-Ford sweeps over the
/// dense exchange graph: where the start is nearly optimal, as after two-opt, few sweeps do.
/// Holds its working memory, so that one object solves many problems; not thread-safe.
class CycleCanceling {
public:
  /// Reorders `target` (and `targetIndex` with it) so that sum <source[i], target[i]> is largest,
  /// up to rounding. The spans have one size n; O(n^2) for each sweep, O(n^4) in all at most.
  void solve(std::span<const Point> source, std::span<Point> target,
             std::span<std::uint32_t> targetIndex);

private:
  static constexpr std::uint32_t kEndOfCycle = 0xFFFFFFFFu;

  void fillRow(std::span<const Point> source, std::span<const Point> target, std::size_t i);
  /// The disjoint cycles of the parent graph, each negative, one after another in cycles_.
  void findCycles();
  [[nodiscard]] bool cancelCycles(std::span<const Point> source, std::span<Point> target,
                                  std::span<std::uint32_t> targetIndex);

  std::size_t stride_ = 0;
  std::vector<float> exchange_;
  std::vector<float> distance_;
  std::vector<std::int32_t> parent_;
  std::vector<std::uint32_t> mark_;
  std::vector<std::uint32_t> cycles_;
  std::vector<std::uint32_t> changed_;
};

} // namespace lichen::transport
