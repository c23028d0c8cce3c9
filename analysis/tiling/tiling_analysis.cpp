// SPDX-License-Identifier: MIT
// Implements for tiling the interface that all methods share.
#include "tiling_analysis.h"

#include "methods/plane_evaluator.h"

#include <lichen/tiling_evaluate.h>

namespace lichen {

Result<std::unique_ptr<const NoiseEvaluator>>
TilingAnalysis::evaluator(const Bundle& bundle, const MaterialNoise& material,
                          const Placement& placement, const EvaluationOptions& options) const {
  return planeEvaluator(TilingEvaluator::create(bundle, material.noise, options.nearestTableLevel),
                        bundle, material, placement);
}

} // namespace lichen
