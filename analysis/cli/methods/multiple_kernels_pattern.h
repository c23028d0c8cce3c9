// SPDX-License-Identifier: MIT
// The option --pattern: the exemplar's strongest waves, waves and splines in text, or a picture ->
// cosines.
#pragma once

#include "../options.h"

#include <lichen/multiple_kernels.h>
#include <lichen/result.h>

#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

namespace lichen::cli {

/// So many of the exemplar's strongest waves.
struct StrongestWaves {
  int cosines = 0;
};
using PatternPart = std::vector<PatternWave>;
struct PatternPicture {
  std::filesystem::path path;
  int repeats = 1; ///< along each axis of the tile
};
using PatternChoice = std::variant<StrongestWaves, std::vector<PatternPart>, PatternPicture>;

/// "cosines:40", "wave:8:0,spline:0:4:1:0:0.5", or the name of a file, also with ":8" after it.
[[nodiscard]] Accepted<std::optional<PatternChoice>> patternChoice();

/// The perturbation of `choice` by `amount`. Errors: as readImage().
[[nodiscard]] Result<Perturbation> perturbationOf(const PatternChoice& choice, double amount);

} // namespace lichen::cli
