// SPDX-License-Identifier: MIT
// Texton noise at points, by the shaders' own code: shaders_glsl/noise/texton.glsl.
#define LICHEN_METHODS 2
#include "evaluation/shader_evaluator.h"

namespace lichen {

std::shared_ptr<const MethodEvaluator> textonEvaluator(const Bundle& bundle, std::size_t noise,
                                                       const EvaluationOptions& options) {
  return std::make_shared<ShaderEvaluator>(bundle, noise, options);
}

} // namespace lichen
