// SPDX-License-Identifier: MIT
// The shifts that nearly repeat an exemplar: bricks, threads, stitches. Tiles that differ by them
// fit together. After Lutz, Sauvage and Dischler 2023 [LSD23], section 4.
#pragma once

#include <lichen/exemplar.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace lichen::placement {

/// What repeats in an exemplar.
struct NearPeriods {
  /// How clearly it repeats: 0 of a random field, 1 of bricks.
  double strength = 0.0;
  /// Shifts in tiles, [-1/2, 1/2), the first of them 0; at least kFewestShifts or none. They are
  /// drawn: no two are close, and each repeats the exemplar together with all before it.
  std::vector<std::array<double, 2>> shifts;
};

inline constexpr std::size_t kFewestShifts = 3;

/// A shift in [-1, 1] tiles along an axis -> whole pixels to the right or down, in
/// [0, side).
[[nodiscard]] inline int pixelsOf(double shift, int side) {
  return (int(std::lround(shift * side)) + side) % side;
}

/// The strength is found by a comparison with a random field of the same smooth spectrum. There are
/// at most `most` shifts, which repeat the exemplar as closely as `guide`, [0, 1], or the strength
/// says; none for 0. Takes the largest maps into account, as periodic images. O(N (log N + most))
/// in their pixels. Deterministic. Throws std::bad_alloc.
[[nodiscard]] NearPeriods nearPeriods(std::span<const MapExemplar> maps, std::size_t most,
                                      std::optional<double> guide = std::nullopt);

} // namespace lichen::placement
