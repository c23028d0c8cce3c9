// SPDX-License-Identifier: MIT
// What a picture says against random blending: it varies at the scale of its size, or shows its
// material at several scales; for heights, by their slopes, which lighting shows.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// The standard deviation, in stored values, of the part of the image at one cycle per side: the
/// frequencies (+-1, 0), (0, +-1) and (+-1, +-1); root mean square over the channels. A ramp of
/// height d has 0.61 of its variance there, which gives 0.225 d. 0 for sides under 8 pixels.
[[nodiscard]] double slowVariation(const MapExemplar& map);

/// The same as a share of the map's nominal range. Components of 8-bit normals are in [-1, 1];
/// light above 1 has no limit but its own maximum.
[[nodiscard]] double slowVariationShare(const MapExemplar& map);

/// The slopes of a height map, as its normal map would have them, by central differences of the
/// heights. Decodes heights stored as log2(1 + height) first. Heights have no stated scale, so
/// kReliefDeviation sets the relief. If `periodic`, differences wrap around the borders; otherwise
/// they are one-sided there. Returns zeros for a constant height. Throws std::bad_alloc.
[[nodiscard]] MapExemplar slopesOfHeight(const MapExemplar& map, bool periodic);

/// By how many octaves of power fine detail gains on coarse detail from one side to the other,
/// along the axis where that is more. Fine and coarse are mean squared differences of brightness at
/// 1 and 8 pixels, in eight strips of the map; the trend is linear. A pixel is a 256th of the
/// shorter side, over which the map is averaged, so a larger map of the same picture has about the
/// same result. A smaller one is measured by its own pixels.
/// 0 for maps other than base colours, and for sides under 128 pixels. Throws std::bad_alloc.
/// Source: docs/decisions/007-verdicts.md.
[[nodiscard]] double unevenScale(const MapExemplar& map);

} // namespace lichen::suitability
