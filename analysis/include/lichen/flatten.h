// SPDX-License-Identifier: MIT
// Removes what varies too slowly to fit in an exemplar and clouds its noise.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <optional>
#include <span>
#include <vector>

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
/// any number of threads. O(N log N); 64 bytes a pixel. Stopped by `progress` it is an Error,
/// environment.
[[nodiscard]] Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                                   const Progress& progress = {});

/// What flattenAutomatically() did, and why.
struct FlatteningChoice {
  enum class Reason {
    mended,   ///< the first map has lost its risks
    calm,     ///< it had neither
    object,   ///< what varies slowly is an object with an outline, which is no light
    stubborn, ///< not even the shortest period would rid it of them
  };

  Reason reason = Reason::calm;
  std::optional<double> periodPixels; ///< of the first map; where it was mended
  std::vector<MapTarget> flattened;   ///< the maps that are changed, in their order
};

/// Flattens by the longest period, in steps of half an octave from twice the longer side of the
/// first map to an eighth of it, whose removal leaves that map neither cloudy nor of low frequency
/// (no mild risk of either name). The others are flattened by the same share of their sides where
/// they have one of the two risks themselves; those that are calm stay as they are, for a
/// photograph's light falls on its colours, and normals, heights and other data have none. Nothing
/// is changed for any other reason than Reason::mended. Maps, errors and threads as above; as long
/// as about five times flatten() and assessSuitability() of the first map, and once of the others.
/// Source: docs/decisions/013-suitability.md.
[[nodiscard]] Result<FlatteningChoice>
flattenAutomatically(std::span<MapExemplar> maps, bool periodic, const Progress& progress = {});

} // namespace lichen
