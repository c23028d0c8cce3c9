// SPDX-License-Identifier: MIT
// The list of methods that are evaluated.
#include "method_evaluator.h"

namespace lichen {

std::shared_ptr<const MethodEvaluator> methodEvaluator(const Bundle& bundle, std::size_t noise,
                                                       const EvaluationOptions& options) {
  static constexpr std::array<MethodEvaluatorMaker*, std::variant_size_v<MethodMap>> kMakers{
      &tilingEvaluator, &textonEvaluator, &localRandomPhaseEvaluator, &multipleKernelsEvaluator,
      &quiltingEvaluator}; // in the order of Method
  return kMakers[std::size_t(bundle.noises[noise].method())](bundle, noise, options);
}

} // namespace lichen
