// SPDX-License-Identifier: MIT
// How good the noise of a photograph is: one line, with the worst fault and what helps.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/measures.h>
#include <lichen/progress.h>
#include <lichen/suitability.h>

#include <span>
#include <string>
#include <vector>

namespace lichen {

/// Returns the risks of each of a noise's exemplars, in the order of `maps`, by the noise's method:
/// assessSuitability() for tiling, assessTextonSuitability() for textons, only "outlines" of the
/// latter for the others, unless their spectrum was given or their structure preserves outlines,
/// and "cuts" for quilting. `maps` are the exemplars as they were baked. What helps a layered noise
/// is never a method that layers do not take. Errors: as both functions.
[[nodiscard]] Result<std::vector<std::vector<Risk>>> assessNoise(const Noise& noise,
                                                                 std::span<const MapExemplar> maps,
                                                                 Periodic borders,
                                                                 const Progress& progress = {});

/// Measures a noise on a small result: two exemplars per side but at most 1024 pixels, or one if
/// that is longer. The measures are the same as of compareNoise(), without lattice_visibility,
/// model_error and flatness, and take 0.6 s for 512 x 512 pixels on two cores. Errors: as
/// compareNoise().
[[nodiscard]] Result<std::vector<Measure>> measureNoise(const Bundle& bundle,
                                                        const MaterialNoise& material,
                                                        const MapExemplar& exemplar,
                                                        const Progress& progress = {});

/// What is known of one map of a noise.
struct JudgedMap {
  MapTarget target = MapTarget::baseColor;
  std::span<const Risk> risks;
  std::span<const Measure> measures; ///< may be empty
};

struct Verdict {
  enum class Level { good, acceptable, unsuitable };

  Level level = Level::good;
  MapTarget map = MapTarget::baseColor; ///< where `worst` is
  /// The risk with the highest score. A measure with a target counts as a risk of its name, scored
  /// by what viewers see, which is mostly more than the target, if its level is higher.
  Risk worst;
};

/// Returns the verdict on all maps together: good if no risk is above level none, acceptable if the
/// worst is mild, and unsuitable if it is severe.
/// `bordersWereKept` says whether the bake took the exemplar's borders to fit together.
/// Source: docs/decisions/007-verdicts.md.
[[nodiscard]] Verdict verdictOn(std::span<const JudgedMap> maps, bool bordersWereKept);

/// "good", "acceptable" or "unsuitable".
[[nodiscard]] std::string_view nameOf(Verdict::Level level);

/// "acceptable: 33 % of the variation repeats regularly; what helps: even light". Names the map if
/// `severalMaps`.
[[nodiscard]] std::string sentenceOf(const Verdict& verdict, bool severalMaps,
                                     SettingWords words = plainWords);

} // namespace lichen
