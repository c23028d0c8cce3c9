// SPDX-License-Identifier: MIT
// The members of a quilting noise and of its maps as JSON.
#include "method_writer.h"

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

void writeNoise(const Noise& noise, Json& json) {
  const auto& shared = noise.as<QuiltingNoise>();
  if (shared.grain != Grain::none)
    json["grain"] = nameOf(shared.grain);
  json["reach"] = shared.reach;
  if (shared.correlation > 0.0)
    json["correlation"] = shared.correlation;
  if (!shared.offsets.empty())
    json["offsets"] = shared.offsets;
}

void writeMap(const NoiseMap& map, Json& json) {
  const auto& own = map.as<QuiltingMap>();
  json["image"] = own.image;
  json["cells"] = own.cells;
}

} // namespace

extern const MethodWriter kQuiltingWriter{writeNoise, writeMap};

} // namespace lichen
