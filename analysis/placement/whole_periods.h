// SPDX-License-Identifier: MIT
// The part of an exemplar that holds whole periods of what repeats in it, straightened.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/tile_corners.h>

#include <optional>

namespace lichen::placement {

/// The largest part whose sides are whole numbers of periods: moved by any combination of the
/// periods, the picture correlates with itself. The sides follow the rows and the columns of what
/// repeats, turned by up to 15 degrees and sheared by up to 10. It is a parallelogram, or a
/// trapezoid of a picture in perspective, which repeats clearly more highly without it. Nothing if
/// the mean correlation is below 0.15. O(N log N) in the pixels. Deterministic. Throws
/// std::bad_alloc. Source: docs/decisions/039-quilting.md.
[[nodiscard]] std::optional<TileCorners> wholePeriods(const MapExemplar& map);

} // namespace lichen::placement
