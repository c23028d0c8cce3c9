// SPDX-License-Identifier: MIT
// Exact assignment of a few points, starting from a nearly optimal one.
#pragma once

#include "point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Cancels negative cycles until none is left [K67]. Bellman-Ford sweeps over the dense exchange
/// graph find them; a nearly optimal start, as after two-opt, needs few sweeps. An object reuses
/// its working memory for many problems. Not thread-safe.
class CycleCanceling {
public:
  /// Reorders `target`, and `targetIndex` with it, to maximize sum <source[i], target[i]> up to
  /// rounding. All spans have the same size n. O(n^2) per sweep, at most O(n^4) in all.
  void solve(std::span<const Point> source, std::span<Point> target,
             std::span<std::uint32_t> targetIndex);

private:
  static constexpr std::uint32_t kEndOfCycle = 0xFFFFFFFFu;

  void fillRow(std::span<const Point> source, std::span<const Point> target, std::size_t i);
  /// Writes the disjoint cycles of the parent graph, all negative, one after another to cycles_.
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
