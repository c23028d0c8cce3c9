// SPDX-License-Identifier: MIT
// Texton noise [GLM17] as a method of the analysis.
#pragma once

#include "methods/method_analysis.h"

namespace lichen {

class TextonAnalysis final : public MethodAnalysis {
public:
  [[nodiscard]] Result<std::unique_ptr<const NoiseEvaluator>>
  evaluator(const Bundle& bundle, const MaterialNoise& material, const Placement& placement,
            const EvaluationOptions& options) const override;
};

} // namespace lichen
