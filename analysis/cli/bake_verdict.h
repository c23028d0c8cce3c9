// SPDX-License-Identifier: MIT
// A baked noise -> its risks, measures and verdict, for `bake` and `compare`.
#pragma once

#include "command.h"

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/noise_verdict.h>

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <vector>

namespace lichen::cli {

struct BakeVerdict {
  std::vector<std::vector<Risk>> assessed; ///< one per map
  std::vector<Measure> measures;           ///< of the first map, on a small result
  Verdict verdict;
};

/// Judges the noise of a material of the bundle, with a progress line. `maps` are the exemplars as
/// they were baked.
[[nodiscard]] Result<BakeVerdict> judgeNoise(const Bundle& bundle, const MaterialNoise& material,
                                             std::span<const MapExemplar> maps, Periodic borders,
                                             bool bordersWereKept, const SharedOptions& options);

/// The line to print: "verdict: good".
[[nodiscard]] std::string verdictLine(const Verdict& verdict, bool severalMaps);

/// {"level", "map", "risk", "score", "sentence"}.
[[nodiscard]] nlohmann::ordered_json jsonOf(const Verdict& verdict);

} // namespace lichen::cli
