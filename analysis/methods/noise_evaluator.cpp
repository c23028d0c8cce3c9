// SPDX-License-Identifier: MIT
// Bundle, material and point -> value, by the noise's method. The CPU twin of
// shaders_glsl/mapping/uv.glsl and noise/tile_frame.glsl.
#include "layered_evaluator.h"
#include "method_analysis.h"

#include <lichen/layered_noise.h>

#include <cmath>

namespace lichen {

Result<std::unique_ptr<const NoiseEvaluator>>
NoiseEvaluator::create(const Bundle& bundle, const MaterialNoise& material,
                       const Placement& placement, const EvaluationOptions& options) {
  if (material.noise >= bundle.noises.size())
    return Error{ErrorKind::usage, "noise " + std::to_string(material.noise) + ": the bundle has " +
                                       std::to_string(bundle.noises.size())};
  const Noise& noise = bundle.noises[material.noise];
  if (const std::string obstacle = mappingObstacle(bundle, material.noise, material.mapping);
      !obstacle.empty())
    return Error{ErrorKind::usage, obstacle};
  if (!takesTileRotation(bundle, material.noise, material.tileRotation))
    return Error{ErrorKind::usage, "noise '" + noise.name + "': tile rotation " +
                                       std::to_string(material.tileRotation) + "; expected " +
                                       std::string(kTileRotations)};
  return withinMemory(
      [&] { return "noise '" + noise.name + "': not enough memory for its tables"; },
      [&] {
        return noise.layers
                   ? layeredEvaluator(bundle, material, placement, options)
                   : analysisOf(noise.method()).evaluator(bundle, material, placement, options);
      });
}

NoiseEvaluator::NoiseEvaluator(const Noise& noise, const shader::LichenTriplanarMaterial& constants)
    : constants_(constants) {
  for (const NoiseMap& map : noise.maps)
    holdsSlopes_.push_back(map.encoding == ValueEncoding::slope);
}

std::array<float, 3> NoiseEvaluator::evaluateGradient(std::size_t map, const TileFootprint& at,
                                                      const MixPlace& mix) const {
  return {evaluate(map, at, mix)[0], 0.0f, 0.0f};
}

NoiseEvaluator::Value NoiseEvaluator::evaluateUv(std::size_t map, const UvFootprint& at) const {
  const auto toTile = [this](const std::array<float, 2>& uv) {
    return std::array{constants().uvToTileXX * uv[0] + constants().uvToTileXY * uv[1],
                      constants().uvToTileYX * uv[0] + constants().uvToTileYY * uv[1]};
  };
  const TileFootprint tile{toTile(at.uv), toTile(at.dx), toTile(at.dy)};
  Value value = evaluate(map, tile, mixAt(at.uv));
  if (holdsSlopes_[map]) { // lichenSlopesToUv
    const float length = std::hypot(constants().uvToTileXX, constants().uvToTileXY);
    const float cosine = constants().uvToTileXX / length, sine = constants().uvToTileXY / length;
    value = {cosine * value[0] + sine * value[1], cosine * value[1] - sine * value[0], value[2],
             value[3]};
  }
  return value;
}

} // namespace lichen
