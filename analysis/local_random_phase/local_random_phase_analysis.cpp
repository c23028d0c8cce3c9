// SPDX-License-Identifier: MIT
// Implements for local random-phase noise the interface that all methods share.
#include "local_random_phase_analysis.h"

#include <lichen/local_random_phase_evaluate.h>

#include <cassert>

namespace lichen {
namespace {

class Evaluator final : public NoiseEvaluator {
public:
  Evaluator(LocalRandomPhaseEvaluator evaluator, const Noise& noise,
            const shader::LichenTriplanarMaterial& constants)
      : NoiseEvaluator(noise, constants), evaluator_(std::move(evaluator)) {}

  [[nodiscard]] Value evaluate(std::size_t map, const TileFootprint& at,
                               const MixPlace&) const override {
    return evaluator_.evaluate(map, constants(), at);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const TriplanarFootprint& at,
                               const MixPlace&) const override {
    return evaluator_.evaluate(map, planes(), at);
  }
  [[nodiscard]] Value evaluate(std::size_t, const SurfaceFootprint&,
                               const MixPlace&) const override {
    assert(!"the mapping surface does not fit, and create() refuses it");
    return {};
  }

private:
  LocalRandomPhaseEvaluator evaluator_;
};

} // namespace

Result<std::unique_ptr<const NoiseEvaluator>>
LocalRandomPhaseAnalysis::evaluator(const Bundle& bundle, const MaterialNoise& material,
                                    const Placement& placement, const EvaluationOptions&) const {
  Result<LocalRandomPhaseEvaluator> created =
      LocalRandomPhaseEvaluator::create(bundle, material.noise);
  if (!created)
    return created.error();
  return std::unique_ptr<const NoiseEvaluator>(
      std::make_unique<Evaluator>(std::move(created).value(), bundle.noises[material.noise],
                                  shaderMaterial(bundle, material, placement)));
}

} // namespace lichen
