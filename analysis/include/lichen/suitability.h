// SPDX-License-Identifier: MIT
// Predicts from an exemplar whether it suits random blending, before anyone uses its noise.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/lattice.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// A setting of a bake, such as one that helps against a risk.
struct BakeSetting {
  std::string_view name; ///< as an option of the command line: "flatten", "support", "method"
  std::string value;     ///< "128"; may be empty where only the setting is named
};

/// One risk that the noise of an exemplar disappoints.
struct Risk {
  enum class Level { none, mild, severe };

  std::string_view name; ///< "cloudiness", "structure", "low-frequency", "clipping",
                         ///< "uneven-scale"; textons: see below
  double score = 0.0;    ///< [0, 1], calibrated: below 1/3 none, below 2/3 mild, else severe
  Level level = Level::none;
  std::string sentence; ///< the visible effect, with the measured number; no full stop
  /// What helps, each by itself; both are empty if the level is none.
  std::vector<BakeSetting> settings;
  std::string advice; ///< another photograph, in words; may be empty
};

/// Puts a setting into the words of a program, for example as a command-line option.
using SettingWords = std::string (*)(const BakeSetting& setting);

/// "flatten 128", or "flatten".
[[nodiscard]] std::string plainWords(const BakeSetting& setting);

/// Returns what helps against a risk: "flatten 128, or even light". Empty if the level is none.
[[nodiscard]] std::string remedyOf(const Risk& risk, SettingWords words = plainWords);

/// "none", "mild" or "severe".
[[nodiscard]] std::string_view nameOf(Risk::Level level);

/// Assesses every risk of one map, in the order of the names above, including risks of level none.
/// `periodic` says whether the exemplar's opposite borders match. A map without variance has no
/// risk. For a height map, cloudiness and low-frequency measure its slopes, which lighting shows.
/// `firstPixels`, above 0, is the length of one pixel of this map in pixels of the first map of the
/// set; a setting that is a period for flatten() counts in those. `grain` is the noise's: the bake
/// fades streaks along it at borders that do not match. Absent: the grain of this map.
/// Errors: usage for maps outside the ranges of MapExemplar, resources if memory runs out,
/// environment if `progress` stops it. Thread-safe; same result for any number of threads.
/// O(N log N) in the number of pixels. Source: docs/decisions/007-verdicts.md.
[[nodiscard]] Result<std::vector<Risk>> assessSuitability(const MapExemplar& map, bool periodic,
                                                          const Progress& progress = {},
                                                          double firstPixels = 1.0,
                                                          std::optional<Grain> grain = {});

/// Assesses the risks of a texton noise of one map, "histogram", "outlines" and "low-frequency":
/// whether the material is a Gaussian texture, and whether `support` texels can hold it. The noise
/// has `widthTexels` x `heightTexels` texels over the map's extent, the size of the largest map of
/// the set; 0 means the map's own size. Errors and threads: as above. O(N log N).
/// Source: docs/decisions/007-verdicts.md.
[[nodiscard]] Result<std::vector<Risk>> assessTextonSuitability(const MapExemplar& map, int support,
                                                                const Progress& progress = {},
                                                                int widthTexels = 0,
                                                                int heightTexels = 0);

} // namespace lichen
