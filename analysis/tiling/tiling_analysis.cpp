// SPDX-License-Identifier: MIT
// Implements for tiling the interface that all methods share.
#include "tiling_analysis.h"

#include <lichen/tiling_evaluate.h>

#include <cassert>

namespace lichen {
namespace {

class Evaluator final : public NoiseEvaluator {
public:
  Evaluator(TilingEvaluator evaluator, const Noise& noise,
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
    assert(!"tiling does not fit the mapping surface, and create() refuses it");
    return {};
  }

private:
  TilingEvaluator evaluator_;
};

} // namespace

Result<std::unique_ptr<const NoiseEvaluator>>
TilingAnalysis::evaluator(const Bundle& bundle, const MaterialNoise& material,
                          const Placement& placement, const EvaluationOptions& options) const {
  Result<TilingEvaluator> created = TilingEvaluator::create(bundle, material.noise, options.tiling);
  if (!created)
    return created.error();
  return std::unique_ptr<const NoiseEvaluator>(
      std::make_unique<Evaluator>(std::move(created).value(), bundle.noises[material.noise],
                                  shaderMaterial(bundle, material, placement)));
}

} // namespace lichen
