// SPDX-License-Identifier: MIT
// A local random-phase noise and its exemplar -> risks and measures.
#include "../method_report.h"
#include "../random_phases.h"

namespace lichen {
namespace {

constexpr GaussianTargets kTargets{1.0, 1.5, true};

Result<std::vector<Risk>> assess(const AssessedMap& assessed, const Progress& progress) {
  const auto& shared = assessed.noise.as<LocalRandomPhaseNoise>();
  if (shared.hasGivenSpectrum) // nobody expects outlines
    return std::vector<Risk>{};
  constexpr double kMost = 0.7; // of the power: a structure of so much keeps outlines
  const std::optional<std::size_t> place = findMap(assessed.noise, assessed.map().target);
  const auto& deviations =
      assessed.noise.maps[place.value_or(0)].as<LocalRandomPhaseMap>().structureDeviations;
  if (!deviations.empty() && deviations[0] * deviations[0] >= kMost)
    return std::vector<Risk>{};
  return outlineRisks(assessed.map(), {{"structure", "1"}}, progress);
}

Result<void> measure(const ComparedResult& result, NoiseComparison& comparison) {
  const Noise& noise = result.bundle.noises[result.options.material.noise];
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  if (shared.structure.columns == 0)
    return judgeRandomPhase(result, shared.hasGivenSpectrum, kTargets, comparison);
  return take(measureResult(comparison.exemplar, comparison.result), comparison);
}

} // namespace

extern const MethodReport kLocalRandomPhaseReport{.assess = assess, .measure = measure};

} // namespace lichen
