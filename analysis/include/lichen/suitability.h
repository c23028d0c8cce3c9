// SPDX-License-Identifier: MIT
// Whether an exemplar suits random blending, told before anyone ships its noise.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// A way in which the noise of an exemplar can disappoint.
struct Risk {
  enum class Level { none, mild, severe };

  std::string_view
      name;           ///< "cloudiness", "structure", "low-frequency", "clipping"; of textons below
  double score = 0.0; ///< [0, 1], calibrated: below 1/3 is none, below 2/3 mild, else severe
  Level level = Level::none;
  std::string sentence; ///< what will be seen, with the measured number; no full stop
  std::string remedy;   ///< the option, or the photograph, that helps; empty where level is none
};

/// "none", "mild" or "severe".
[[nodiscard]] std::string_view nameOf(Risk::Level level);

/// Every risk of one map, in the order of the names above, those of no concern included.
/// `periodic`: whether the exemplar's opposite borders fit together. A map without variance has
/// none. Of a height map cloudiness and low frequency are those of its slopes, which light shows.
/// `firstPixels`, above 0: how many pixels of the first map of the set one pixel of this map is as
/// long as; a remedy that is a period for flatten() counts those.
/// Errors: usage for maps outside the ranges of MapExemplar, resources for memory, environment when
/// `progress` stops it. Thread-safe; the same result for any number of threads. O(N log N) in the
/// number of pixels. Source: docs/decisions/013-suitability.md.
[[nodiscard]] Result<std::vector<Risk>> assessSuitability(const MapExemplar& map, bool periodic,
                                                          const Progress& progress = {},
                                                          double firstPixels = 1.0);

/// The risks of a texton noise of one map, "histogram", "outlines" and "low-frequency": whether the
/// material is a Gaussian texture at all, and whether `support` texels hold it. The noise has
/// `widthTexels` x `heightTexels` of them where the map has its pixels, those of the largest map of
/// the set; 0: as many as the map has. Errors and threads as above. O(N log N).
/// Source: docs/decisions/017-texton-risks.md.
[[nodiscard]] Result<std::vector<Risk>> assessTextonSuitability(const MapExemplar& map, int support,
                                                                const Progress& progress = {},
                                                                int widthTexels = 0,
                                                                int heightTexels = 0);

} // namespace lichen
