// SPDX-License-Identifier: MIT
// A synthetic texton noise with its parameters and its evaluator.
#pragma once

#include "synthetic_texton.h"

#include <array>
#include <evaluation/method_evaluator.h>

namespace lichen::test {

[[nodiscard]] inline MaterialNoise materialOf(PointProcess process, double impacts,
                                              std::uint32_t seed) {
  MaterialNoise material;
  material.pointProcess = process;
  material.impacts = impacts;
  material.seed = seed;
  return material;
}

struct TextonEvaluation {
  TextonEvaluation(const SyntheticTexton& source, const MaterialNoise& materialNoise,
                   const Placement& placement = {})
      : bundle(syntheticTextonBundle(source).bundle), evaluator(methodEvaluator(bundle, 0)),
        material(shaderMaterial(bundle, materialNoise, placement)),
        part(partOf<shader::LichenTextonMaterial>(material.material)),
        constants(shaderNoise(bundle, 0)) {}

  /// Stored values minus their mean at a position in the plane or on a surface.
  [[nodiscard]] std::array<double, 3> storedAt(const Footprint& place) const {
    const std::array<float, 3> gaussian = evaluator->gaussian(0, material, place).value;
    const std::vector<double>& scale = bundle.noises[0].maps[0].as<TextonMap>().scale;
    std::array<double, 3> stored{};
    for (std::size_t c = 0; c < scale.size(); ++c)
      stored[c] = (double(gaussian[c]) - 0.5) * scale[c];
    return stored;
  }

  Bundle bundle;
  std::shared_ptr<const MethodEvaluator> evaluator;
  shader::LichenTriplanarMaterial material;
  shader::LichenTextonMaterial part;
  shader::LichenNoise constants;
};

} // namespace lichen::test
