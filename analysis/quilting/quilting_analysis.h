// SPDX-License-Identifier: MIT
// Implements for quilting the interface that all methods share.
#pragma once

#include "methods/method_analysis.h"

namespace lichen {

class QuiltingAnalysis final : public MethodAnalysis {
public:
  [[nodiscard]] Result<std::unique_ptr<const NoiseEvaluator>>
  evaluator(const Bundle& bundle, const MaterialNoise& material, const Placement& placement,
            const EvaluationOptions& options) const override;
};

} // namespace lichen
