// SPDX-License-Identifier: MIT
// Tiling and blending at points, by the shaders' own code: shaders_glsl/noise/tiling.glsl.
#define LICHEN_METHODS 1
#include "evaluation/shader_evaluator.h"

namespace lichen {

std::shared_ptr<const MethodEvaluator> tilingEvaluator(const Bundle& bundle, std::size_t noise,
                                                       const EvaluationOptions& options) {
  return std::make_shared<ShaderEvaluator>(bundle, noise, options, tilingWide);
}

} // namespace lichen
