// SPDX-License-Identifier: MIT
// The interface of a method in the analysis. Each method implements it in its own folder;
// methods.cpp lists the implementations.
#pragma once

#include <lichen/noise_evaluator.h>

#include <memory>

namespace lichen {

class MethodAnalysis {
public:
  virtual ~MethodAnalysis() = default;

  /// As NoiseEvaluator::create(), which checks the noise and the mapping first.
  [[nodiscard]] virtual Result<std::unique_ptr<const NoiseEvaluator>>
  evaluator(const Bundle& bundle, const MaterialNoise& material, const Placement& placement,
            const EvaluationOptions& options) const = 0;
};

[[nodiscard]] const MethodAnalysis& analysisOf(Method method);

} // namespace lichen
