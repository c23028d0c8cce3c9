// SPDX-License-Identifier: MIT
// A multiple-kernels noise and its exemplar -> risks and measures.
#include "../method_report.h"
#include "../random_phases.h"

namespace lichen {
namespace {

constexpr GaussianTargets kTargets{0.5, 1.5, true};

Result<std::vector<Risk>> assess(const AssessedMap& assessed, const Progress& progress) {
  if (assessed.noise.as<MultipleKernelsNoise>().hasGivenSpectrum) // nobody expects outlines
    return std::vector<Risk>{};
  return outlineRisks(assessed.map(), {}, progress);
}

Result<void> measure(const ComparedResult& result, NoiseComparison& comparison) {
  const Noise& noise = result.bundle.noises[result.options.material.noise];
  return judgeRandomPhase(result, noise.as<MultipleKernelsNoise>().hasGivenSpectrum, kTargets,
                          comparison);
}

} // namespace

extern const MethodReport kMultipleKernelsReport{.assess = assess, .measure = measure};

} // namespace lichen
