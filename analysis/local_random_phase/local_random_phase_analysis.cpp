// SPDX-License-Identifier: MIT
// Implements for local random-phase noise the interface that all methods share.
#include "local_random_phase_analysis.h"

#include "methods/plane_evaluator.h"

#include <lichen/local_random_phase_evaluate.h>

namespace lichen {

Result<std::unique_ptr<const NoiseEvaluator>>
LocalRandomPhaseAnalysis::evaluator(const Bundle& bundle, const MaterialNoise& material,
                                    const Placement& placement, const EvaluationOptions&) const {
  return planeEvaluator(LocalRandomPhaseEvaluator::create(bundle, material.noise), bundle, material,
                        placement);
}

} // namespace lichen
