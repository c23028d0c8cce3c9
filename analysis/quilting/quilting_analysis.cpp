// SPDX-License-Identifier: MIT
#include "quilting_analysis.h"

#include "methods/plane_evaluator.h"

#include <lichen/quilting_evaluate.h>

namespace lichen {

Result<std::unique_ptr<const NoiseEvaluator>>
QuiltingAnalysis::evaluator(const Bundle& bundle, const MaterialNoise& material,
                            const Placement& placement, const EvaluationOptions&) const {
  return planeEvaluator(QuiltingEvaluator::create(bundle, material.noise), bundle, material,
                        placement);
}

} // namespace lichen
