// SPDX-License-Identifier: MIT
// Adapts texton noise to the common interface of all methods.
#include "texton_analysis.h"

#include <lichen/texton_evaluate.h>

#include <cassert>

namespace lichen {
namespace {

class Evaluator final : public NoiseEvaluator {
public:
  Evaluator(TextonEvaluator evaluator, const Noise& noise,
            const shader::LichenTriplanarMaterial& constants)
      : NoiseEvaluator(noise, constants), evaluator_(std::move(evaluator)),
        texton_(textonPart(constants.material)) {}

  [[nodiscard]] Value evaluate(std::size_t map, const TileFootprint& at,
                               const MixPlace& mix) const override {
    return evaluator_.evaluate(map, constants(), at, mix);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const TriplanarFootprint& at,
                               const MixPlace& mix) const override {
    return evaluator_.evaluate(map, planes(), at, mix);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const SurfaceFootprint& at,
                               const MixPlace& mix) const override {
    return evaluator_.evaluate(map, constants(), at, mix);
  }
  [[nodiscard]] Value evaluate(std::size_t, const SolidFootprint&) const override {
    assert(!"textons do not fit the mapping solid, and create() refuses it");
    return {};
  }
  [[nodiscard]] std::array<float, 3> evaluateGradient(std::size_t map, const TileFootprint& at,
                                                      const MixPlace& mix) const override {
    return evaluator_.gradient(map, constants(), at, mix);
  }

private:
  /// The CPU twin of lichenMixByUv (shaders_glsl/mapping/uv.glsl).
  [[nodiscard]] MixPlace mixAt(const std::array<float, 2>& uv) const override {
    const shader::LichenMaterial& material = constants();
    const float square =
        material.uvToTileXX * material.uvToTileXX + material.uvToTileXY * material.uvToTileXY;
    return {
        texton_.mixWeight + texton_.mixPerU * uv[0] + texton_.mixPerV * uv[1],
        {(material.uvToTileXX * texton_.mixPerU + material.uvToTileXY * texton_.mixPerV) / square,
         (material.uvToTileYX * texton_.mixPerU + material.uvToTileYY * texton_.mixPerV) / square}};
  }

  TextonEvaluator evaluator_;
  shader::LichenTextonMaterial texton_;
};

} // namespace

Result<std::unique_ptr<const NoiseEvaluator>>
TextonAnalysis::evaluator(const Bundle& bundle, const MaterialNoise& material,
                          const Placement& placement, const EvaluationOptions&) const {
  Result<TextonEvaluator> created = TextonEvaluator::create(bundle, material.noise);
  if (!created)
    return created.error();
  return std::unique_ptr<const NoiseEvaluator>(
      std::make_unique<Evaluator>(std::move(created).value(), bundle.noises[material.noise],
                                  shaderMaterial(bundle, material, placement)));
}

} // namespace lichen
