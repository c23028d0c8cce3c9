// SPDX-License-Identifier: MIT
// Adapts texton noise to the common interface of all methods.
#include "texton_analysis.h"

#include <lichen/texton_evaluate.h>

namespace lichen {
namespace {

class Evaluator final : public NoiseEvaluator {
public:
  Evaluator(TextonEvaluator evaluator, const Noise& noise, const shader::LichenNoise& constants,
            const shader::LichenTexton& texton)
      : NoiseEvaluator(noise, constants), evaluator_(std::move(evaluator)), texton_(texton) {}

  [[nodiscard]] Value evaluate(std::size_t map, const TileFootprint& at,
                               const MixPlace& mix) const override {
    return evaluator_.evaluate(map, constants(), texton_, at, mix);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const TriplanarFootprint& at,
                               const MixPlace& mix) const override {
    return evaluator_.evaluate(map, constants(), texton_, at, mix);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const SurfaceFootprint& at,
                               const MixPlace& mix) const override {
    return evaluator_.evaluate(map, constants(), texton_, at, mix);
  }

private:
  /// The CPU twin of lichenMixByUv (shaders_glsl/mapping/uv.glsl).
  [[nodiscard]] MixPlace mixAt(const std::array<float, 2>& uv) const override {
    const shader::LichenNoise& noise = constants();
    const float square = noise.uvToTileXX * noise.uvToTileXX + noise.uvToTileXY * noise.uvToTileXY;
    return {texton_.mixWeight + texton_.mixPerU * uv[0] + texton_.mixPerV * uv[1],
            {(noise.uvToTileXX * texton_.mixPerU + noise.uvToTileXY * texton_.mixPerV) / square,
             (noise.uvToTileYX * texton_.mixPerU + noise.uvToTileYY * texton_.mixPerV) / square}};
  }

  TextonEvaluator evaluator_;
  shader::LichenTexton texton_;
};

} // namespace

Result<std::unique_ptr<const NoiseEvaluator>>
TextonAnalysis::evaluator(const Bundle& bundle, const MaterialNoise& material,
                          const Placement& placement, const EvaluationOptions&) const {
  Result<TextonEvaluator> created = TextonEvaluator::create(bundle, material.noise);
  if (!created)
    return created.error();
  return std::unique_ptr<const NoiseEvaluator>(std::make_unique<Evaluator>(
      std::move(created).value(), bundle.noises[material.noise],
      shaderNoise(bundle, material, placement), shaderTexton(bundle, material, placement)));
}

} // namespace lichen
