// SPDX-License-Identifier: MIT
// Implements for multiple-kernels noise the interface that all methods share.
#include "multiple_kernels_analysis.h"

#include "methods/plane_evaluator.h"

#include <lichen/multiple_kernels_evaluate.h>

namespace lichen {

Result<std::unique_ptr<const NoiseEvaluator>>
MultipleKernelsAnalysis::evaluator(const Bundle& bundle, const MaterialNoise& material,
                                   const Placement& placement, const EvaluationOptions&) const {
  return planeEvaluator(MultipleKernelsEvaluator::create(bundle, material.noise), bundle, material,
                        placement);
}

} // namespace lichen
