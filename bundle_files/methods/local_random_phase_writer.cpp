// SPDX-License-Identifier: MIT
// The members of a local random-phase noise and of its maps as JSON.
#include "method_writer.h"

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

void writeNoise(const Noise& noise, Json& json) {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  json["localRandomPhase"] = {{"texelsPerTile", {shared.texelsPerTileX, shared.texelsPerTileY}},
                              {"columns", shared.columns},
                              {"rows", shared.rows},
                              {"octaves", shared.cosines},
                              {"variants", shared.variants}};
  if (shared.hasGivenSpectrum)
    json["localRandomPhase"]["spectrum"] = "given";
  const CosineStructure& structure = shared.structure;
  if (structure.columns == 0)
    return;
  Json& own = json["localRandomPhase"]["structure"];
  own["texels"] = {structure.columns, structure.rows};
  if (structure.offsets > 0)
    own["offsets"] = structure.offsets;
  if (structure.turbulence > 0.0)
    own["turbulence"] = structure.turbulence;
}

void writeMap(const NoiseMap& map, Json& json) {
  const auto& own = map.as<LocalRandomPhaseMap>();
  json["dimensions"] = own.dimensions;
  json["cosines"] = own.cosines;
  if (!own.structureAmplitudes.empty())
    json["structure"] = {{"amplitudes", own.structureAmplitudes},
                         {"deviations", own.structureDeviations}};
  if (own.inverseTable)
    json["inverseTable"] = *own.inverseTable;
}

} // namespace

extern const MethodWriter kLocalRandomPhaseWriter{writeNoise, writeMap};

} // namespace lichen
