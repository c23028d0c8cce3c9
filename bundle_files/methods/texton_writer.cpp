// SPDX-License-Identifier: MIT
// The members of a texton noise and of its maps as JSON.
#include "method_writer.h"

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

void writeNoise(const Noise& noise, Json& json) {
  const auto& shape = noise.as<TextonShape>();
  json["texton"] = {{"coefficients", {shape.coefficientsX, shape.coefficientsY}},
                    {"order", shape.order},
                    {"mipLevels", shape.mipLevels},
                    {"texelsPerTile", {shape.texelsPerTileX, shape.texelsPerTileY}},
                    {"steps", shape.steps}};
}

void writeMap(const NoiseMap& map, Json& json) {
  const auto& texton = map.as<TextonMap>();
  json["texton"] = texton.image;
  json["scale"] = texton.scale;
  json["mipLoss"] = texton.mipLoss;
  for (const TextonStep& step : texton.laterSteps)
    json["laterSteps"].push_back(
        {{"mean", step.mean}, {"covariance", step.covariance}, {"mipLoss", step.mipLoss}});
}

} // namespace

extern const MethodWriter kTextonWriter{writeNoise, writeMap};

} // namespace lichen
