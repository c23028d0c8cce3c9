// SPDX-License-Identifier: MIT
// Reads the mix weight of a material.
#include "extension_reader.h"

#include <cmath>

namespace lichen {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMaxColorSet = 15;
constexpr std::uint64_t kMaxChannel = 3; // alpha

void readDirection(ObjectReader& reader, MixWeight& mix) {
  mix.start = reader.pairOr("start", kMixPlaceRange, mix.start);
  mix.end = reader.pairOr("end", kMixPlaceRange, mix.end);
  if (std::hypot(mix.end[0] - mix.start[0], mix.end[1] - mix.start[1]) < kLeastMixLength)
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
  mix.texCoord = info.integerOr("texCoord", kMaxTexCoord, mix.texCoord);
  info.warnOfUnknown();
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
    mix.channel = reader.integerOr("channel", kMaxChannel, mix.channel);
    break;
  case MixSource::vertexColor:
    mix.colorSet = reader.integerOr("set", kMaxColorSet, mix.colorSet);
    mix.channel = reader.integerOr("channel", kMaxChannel, mix.channel);
    break;
  }
  reader.warnOfUnknown();
  return mix;
}

} // namespace lichen
