// SPDX-License-Identifier: MIT
// Local random-phase noise at points, by the shaders' own code:
// shaders_glsl/noise/local_random_phase.glsl.
#define LICHEN_METHODS 4
#include "evaluation/shader_evaluator.h"

namespace lichen {

std::shared_ptr<const MethodEvaluator> localRandomPhaseEvaluator(const Bundle& bundle,
                                                                 std::size_t noise,
                                                                 const EvaluationOptions& options) {
  return std::make_shared<ShaderEvaluator>(bundle, noise, options, localRandomPhaseWide);
}

} // namespace lichen
