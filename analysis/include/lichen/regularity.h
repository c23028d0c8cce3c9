// SPDX-License-Identifier: MIT
// How clearly something repeats in an exemplar, such as bricks, and the part of it that holds whole
// periods.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/result.h>

#include <optional>
#include <span>
#include <vector>

namespace lichen {

/// A smaller picture shows too little to tell. [pixels]
inline constexpr int kLeastRegularSide = 128;
/// Streaks of wood repeat by chance, but have no outlines.
inline constexpr double kLeastOutlines = 0.15;
/// What holds an exemplar together by itself: outlines, or a strength of repetition.
inline constexpr double kClearOutlines = 0.25, kClearStrength = 0.3;
/// How closely a noise follows what repeats: 0 not at all.
inline constexpr NumberRange kGuideRange{0.0, 1.0};

struct Regularity {
  double outlines = 0.0;   ///< [0, 1] how much outlines, such as joints, hold it together
  double strength = 0.0;   ///< how clearly it repeats: 0 of a random field, 1 of bricks
  bool hasLattice = false; ///< whether two vectors clearly repeat it
  /// The largest part of the first map whose opposite borders lie alike in what repeats, which may
  /// be turned and seen in perspective. Nothing if the map's own borders fit together, and look
  /// alike or agree with what repeats; or if nothing repeats clearly.
  std::optional<TileCorners> wholePeriods;

  [[nodiscard]] bool repeats() const { return isStrong() || hasLattice; }
  /// Whether random blending breaks it into pieces.
  [[nodiscard]] bool isClear() const { return repeats() || outlines >= kClearOutlines; }
  /// How closely a bake should follow what repeats. Absent: as closely as the strength says; 1 if
  /// only the lattice shows that it repeats.
  [[nodiscard]] std::optional<double> guide() const {
    return hasLattice && !isStrong() ? std::optional(kGuideRange.most) : std::nullopt;
  }

private:
  [[nodiscard]] bool isStrong() const { return strength >= kClearStrength; }
};
/// Measures the exemplar: outlines by its first map; how clearly it repeats by its largest maps,
/// inside the part that holds whole periods, but not if outlines are less than kLeastOutlines and
/// no lattice repeats the first map highly. Nothing is clear in a first map with a side under 128
/// pixels. Errors: resources if memory runs out. Deterministic. O(N log N) in the number of pixels.
/// Source: docs/decisions/012-quilting.md.
[[nodiscard]] Result<Regularity> regularityOf(std::span<const MapExemplar> maps, Periodic periodic);

/// Replaces each map by the part of it between the corners, which are in pixels of the first map,
/// as wide and as high as its sides are long on average; at least one pixel. Slopes turn with the
/// part. Precondition: areConvex(corners). Errors: resources if memory runs out.
[[nodiscard]] Result<void> rectify(std::span<MapExemplar> maps, const TileCorners& corners);

} // namespace lichen
