// SPDX-License-Identifier: MIT
// Reads the mix weight of a material.
#include "extension_reader.h"

#include <cmath>

namespace lichen {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMaxColorSet = 15;
constexpr std::uint64_t kMaxChannel = 3; // alpha

/// An optional pair of texture coordinates, with its default.
std::array<double, 2> readPlace(ObjectReader& reader, const char* key,
                                const std::array<double, 2>& preset) {
  if (!reader.has(key))
    return preset;
  const auto place = reader.numbers(key, kMixPlaceRange);
  if (place && place->size() == 2)
    return {(*place)[0], (*place)[1]};
  if (place)
    reader.error("count", key, std::to_string(place->size()) + " values; expected 2");
  return preset;
}

void readDirection(ObjectReader& reader, MixWeight& mix) {
  mix.start = readPlace(reader, "start", mix.start);
  mix.end = readPlace(reader, "end", mix.end);
  if (std::hypot(mix.end[0] - mix.start[0], mix.end[1] - mix.start[1]) < kLeastMixWay)
    reader.error("mix-direction", "end",
                 "closer than 0.000001 to start; expected a place further away");
}

/// Reads a glTF textureInfo.
void readTexture(ObjectReader& reader, std::size_t textures, FindingList& findings,
                 MixWeight& mix) {
  const json* member = reader.required("texture");
  if (member == nullptr)
    return;
  ObjectReader info(*member, reader.pointerTo("texture"), findings);
  const auto index = info.integer("index", textures == 0 ? 0 : textures - 1, "mix-texture-index");
  if (index && textures == 0)
    info.error("mix-texture-index", "index", "there are no textures");
  mix.texture = std::size_t(index.value_or(0));
  if (info.has("texCoord"))
    mix.texCoord = int(info.integer("texCoord", kMaxTexCoord).value_or(0));
  info.warnOfUnknown();
}

int readChannel(ObjectReader& reader) {
  return reader.has("channel") ? int(reader.integer("channel", kMaxChannel).value_or(0)) : 0;
}

} // namespace

MixWeight readMixWeight(ObjectReader& material, std::size_t textures, FindingList& findings) {
  MixWeight mix;
  const json* member = material.optional("mix");
  if (member == nullptr)
    return mix;
  ObjectReader reader(*member, material.pointerTo("mix"), findings);
  if (const auto name = reader.text("source")) {
    const auto source = mixSourceFrom(*name);
    if (!source)
      reader.error("mix-source", "source",
                   quoted(*name) + "; expected constant, direction, texture or vertexColor");
    mix.source = source.value_or(mix.source);
  }
  switch (mix.source) {
  case MixSource::constant:
    mix.weight = reader.numberOr("weight", kMixWeightRange, mix.weight);
    break;
  case MixSource::direction:
    readDirection(reader, mix);
    break;
  case MixSource::texture:
    readTexture(reader, textures, findings, mix);
    mix.channel = readChannel(reader);
    break;
  case MixSource::vertexColor:
    if (reader.has("set"))
      mix.colorSet = int(reader.integer("set", kMaxColorSet).value_or(0));
    mix.channel = readChannel(reader);
    break;
  }
  reader.warnOfUnknown();
  return mix;
}

} // namespace lichen
