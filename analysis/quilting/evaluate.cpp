// SPDX-License-Identifier: MIT
// Quilting at points, by the shaders' own code: shaders_glsl/noise/quilting.glsl.
#define LICHEN_METHODS 16
#include "evaluation/shader_evaluator.h"

namespace lichen {

std::shared_ptr<const MethodEvaluator> quiltingEvaluator(const Bundle& bundle, std::size_t noise,
                                                         const EvaluationOptions& options) {
  return std::make_shared<ShaderEvaluator>(bundle, noise, options);
}

} // namespace lichen
