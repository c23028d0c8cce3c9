// SPDX-License-Identifier: MIT
// Removes what varies too slowly to fit in an exemplar and clouds its noise.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/tiling.h>

#include <optional>
#include <span>

namespace lichen {

/// Of variation that can be removed, in pixels.
inline constexpr NumberRange kFlattenPeriodRange{4.0, 16384.0};

/// Removes from every map what varies more slowly than `periodPixels` of the first one, in
/// kFlattenPeriodRange; the others, by their size, have the same share of theirs. The filter halves
/// waves of that period and takes 1/16 of those half as long; at the borders the image is continued
/// by itself if `periodic`, else by its mirror image. Base colours and emissive light are divided
/// by their low-passed light, as uneven light is a factor, and clipped at white; from other maps
/// the low-passed values are subtracted, and those but slopes stay within their range. Means are
/// kept up to what is clipped. Opacity stays as it is: its coverage is the material's shape. At
/// least one map, each within the ranges of MapExemplar; unspecified after an Error. Errors: usage
/// for maps or a period out of range, resources for memory. Thread-safe, and the same values for
/// any number of threads. O(N log N); 64 bytes a pixel.
[[nodiscard]] Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic);

/// The longest period, in steps of half an octave from twice the longer side to an eighth of it,
/// whose removal leaves the map neither cloudy nor of low frequency (no mild risk of either name).
/// Nothing for a map that has neither risk, and for one that not even the shortest would rid of
/// them. Errors and threads as above; as long as about four times flatten() and
/// assessSuitability().
[[nodiscard]] Result<std::optional<double>> flatteningPeriod(const MapExemplar& map, bool periodic);

} // namespace lichen
