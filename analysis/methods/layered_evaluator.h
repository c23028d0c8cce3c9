// SPDX-License-Identifier: MIT
// Evaluates a layered noise: the CPU twin of shaders_glsl/noise/layers.glsl.
#pragma once

#include <lichen/noise_evaluator.h>

namespace lichen {

/// As NoiseEvaluator::create(), for a material whose noise is layered.
[[nodiscard]] Result<std::unique_ptr<const NoiseEvaluator>>
layeredEvaluator(const Bundle& bundle, const MaterialNoise& material, const Placement& placement,
                 const EvaluationOptions& options);

} // namespace lichen
