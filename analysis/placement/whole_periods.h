// SPDX-License-Identifier: MIT
// The part of an exemplar that holds whole periods of what repeats in it, straightened.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/tile_corners.h>

#include <optional>

namespace lichen::placement {

/// Larger pictures are averaged to at most so many pixels a side.
inline constexpr int kMostPeriodSide = 700;

struct WholePeriods {
  /// The mean correlation of the picture with itself, moved by the vectors of the lattice that
  /// repeats it most highly, less its standard error. At most 1; 0 without a lattice.
  double correlation = 0.0;
  /// How much lower the correlation is half way between those vectors, as a share of it, where it
  /// falls least. Streaks, which repeat by chance, hardly fall along themselves.
  double contrast = 0.0;
  /// Whether the lattice is more than chance: the correlation is at least 0.25, or 0.45 if the
  /// picture holds fewer than 8 periods.
  bool areSure = false;
  /// The largest part whose sides are whole numbers of periods, which follow the rows and the
  /// columns of what repeats, turned by up to 25 degrees and sheared by up to 10. It is a
  /// parallelogram, or another quadrilateral of a picture in perspective, which repeats clearly
  /// more highly without it. It lies where its opposite borders fit best, as in joints. Nothing
  /// unless areSure.
  std::optional<TileCorners> part;
};

/// `bordersFit` says that the picture's own borders seem to fit together; then there is no part
/// unless they do not look alike and a side of the picture clearly is no whole number of periods.
/// O(N log N) in the pixels. Deterministic. Throws std::bad_alloc. Source:
/// docs/decisions/012-quilting.md.
[[nodiscard]] WholePeriods wholePeriods(const MapExemplar& map, bool bordersFit = false);

} // namespace lichen::placement
