// SPDX-License-Identifier: MIT
// The members of a multiple-kernels noise and of its maps as JSON.
#include "method_writer.h"

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

void writeNoise(const Noise& noise, Json& json) {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  Json& own = json["multipleKernels"];
  own = {{"texelsPerTile", {shared.texelsPerTileX, shared.texelsPerTileY}},
         {"kernels", shared.kernels}};
  if (shared.rings > 0)
    own["rings"] = shared.rings;
  if (shared.cosines > 0)
    own["cosines"] = shared.cosines;
  own["window"] = nameOf(shared.window);
  if (shared.hasGivenSpectrum)
    own["spectrum"] = "given";
}

void writeMap(const NoiseMap& map, Json& json) {
  const auto& own = map.as<MultipleKernelsMap>();
  json["dimensions"] = own.dimensions;
  json["kernels"] = own.kernels;
  if (own.inverseTable)
    json["inverseTable"] = *own.inverseTable;
}

} // namespace

extern const MethodWriter kMultipleKernelsWriter{writeNoise, writeMap};

} // namespace lichen
