// SPDX-License-Identifier: MIT
// Multiple-kernels noise at points, by the shaders' own code:
// shaders_glsl/noise/multiple_kernels.glsl.
#define LICHEN_METHODS 8
#include "evaluation/shader_evaluator.h"

namespace lichen {

std::shared_ptr<const MethodEvaluator> multipleKernelsEvaluator(const Bundle& bundle,
                                                                std::size_t noise,
                                                                const EvaluationOptions& options) {
  return std::make_shared<ShaderEvaluator>(bundle, noise, options);
}

} // namespace lichen
