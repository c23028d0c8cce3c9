// SPDX-License-Identifier: MIT
// A synthetic texton noise with its parameters and its CPU twin.
#pragma once

#include "synthetic_texton.h"

#include <lichen/texton_evaluate.h>

#include <array>

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
      : bundle(syntheticTextonBundle(source).bundle),
        twin(TextonEvaluator::create(bundle, 0).value()),
        material(shaderMaterial(bundle, materialNoise, placement).material),
        part(textonPart(material)), constants(shaderNoise(bundle, 0)) {}

  /// Stored values minus their mean at a position in the plane or on a surface.
  template <class Footprint>
  [[nodiscard]] std::array<double, 3> storedAt(const Footprint& place) const {
    const TextonEvaluator::Value gaussian = twin.gaussian(0, material, place);
    const std::vector<double>& scale = bundle.noises[0].maps[0].as<TextonMap>().scale;
    std::array<double, 3> stored{};
    for (std::size_t c = 0; c < scale.size(); ++c)
      stored[c] = (double(gaussian[c]) - 0.5) * scale[c];
    return stored;
  }

  Bundle bundle;
  TextonEvaluator twin;
  shader::LichenMaterial material;
  shader::LichenTextonMaterial part;
  shader::LichenNoise constants;
};

} // namespace lichen::test
