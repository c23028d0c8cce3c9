// SPDX-License-Identifier: MIT
// The extension's JSON, in the order of the specification's tables.
#include "extension_writer.h"

#include "methods/method_writer.h"

#include <lichen/bundle_writer.h>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

Json describeMap(const NoiseMap& map, const MethodWriter& writer) {
  Json json = {{"target", nameOf(map.target)}, {"channels", Json::array()}};
  for (const MapChannel channel : map.channels)
    json["channels"].push_back(nameOf(channel));
  json["encoding"] = nameOf(map.encoding);
  json["mean"] = map.mean;
  json["covariance"] = map.covariance;
  writer.writeMap(map, json);
  return json;
}

Json describeMix(const MixWeight& mix) {
  Json json = {{"source", nameOf(mix.source)}};
  switch (mix.source) {
  case MixSource::constant:
    json["weight"] = mix.weight;
    break;
  case MixSource::direction:
    json["start"] = mix.start;
    json["end"] = mix.end;
    break;
  case MixSource::texture:
    json["texture"] = {{"index", mix.texture}};
    if (mix.texCoord != 0)
      json["texture"]["texCoord"] = mix.texCoord;
    break;
  case MixSource::vertexColor:
    json["set"] = mix.colorSet;
    break;
  }
  if (mix.channel != 0)
    json["channel"] = mix.channel;
  return json;
}

/// The node `index` of the layers of the noise `own`, and all below it.
Json describeNode(const NoiseLayers& layers, std::size_t index, std::size_t own) {
  const auto noiseOrNode = [&](const LayerSide& side) -> Json {
    if (side.isNode)
      return describeNode(layers, side.index, own);
    return side.index == 0 ? own : layers.others[side.index - 1];
  };
  const LayerNode& node = layers.nodes[index];
  return {{"index", node.index},
          {"proportion", node.proportion},
          {"softness", node.softness},
          {"below", noiseOrNode(node.below)},
          {"above", noiseOrNode(node.above)}};
}

/// The members that differ from their defaults.
Json describePreparation(const Preparation& preparation) {
  Json json = Json::object();
  if (preparation.isGreenDown)
    json["normals"] = "directX";
  if (preparation.usesAlpha)
    json["alpha"] = "opacity";
  if (preparation.crop)
    json["crop"] = *preparation.crop;
  if (preparation.periodic)
    json["periodic"] = *preparation.periodic;
  if (preparation.size)
    json["size"] = *preparation.size;
  for (const FilledPlace& filled : preparation.filled)
    json["filled"].push_back({{"place", filled.place}, {"from", filled.from}});
  if (preparation.corners)
    for (const auto& [x, y] : *preparation.corners)
      for (const double value : {x, y})
        json["corners"].push_back(value);
  if (!preparation.flattened.empty()) {
    Json& flattened =
        json["flattened"] = {{"period", preparation.flattenPeriod}, {"maps", Json::array()}};
    for (const MapTarget map : preparation.flattened)
      flattened["maps"].push_back(nameOf(map));
  }
  return json;
}

} // namespace

Json describeNoise(const Noise& noise, std::size_t index) {
  const MethodWriter& writer = writerOf(noise.method());
  Json json = {{"name", noise.name},
               {"method", nameOf(noise.method())},
               {"revision", revisionOf(noise.method())},
               {"tileSize", noise.tileSizeMetres}};
  writer.writeNoise(noise, json);
  if (noise.preparation != Preparation{})
    json["preparation"] = describePreparation(noise.preparation);
  json["maps"] = Json::array();
  for (const NoiseMap& map : noise.maps)
    json["maps"].push_back(describeMap(map, writer));
  if (noise.layers)
    json["layers"] = describeNode(*noise.layers, 0, index);
  return json;
}

Json describeTable(const Table& table, std::size_t bufferView) {
  Json json = Json::object();
  if (!table.name.empty())
    json["name"] = table.name;
  json["bufferView"] = bufferView;
  json["mimeType"] = "image/ktx2";
  return json;
}

Json describeBundle(const Bundle& bundle, GltfBuilder& builder) {
  Json json = {{"tables", Json::array()}, {"noises", Json::array()}};
  for (const Table& table : bundle.tables)
    json["tables"].push_back(
        describeTable(table, builder.addView(encodeKtx2(table), kTableAlignment)));
  for (std::size_t n = 0; n < bundle.noises.size(); ++n)
    json["noises"].push_back(describeNoise(bundle.noises[n], n));
  return json;
}

Json describeMaterialNoise(const MaterialNoise& use) {
  const MaterialNoise defaults;
  Json json = {{"noise", use.noise}};
  const auto add = [&](const char* key, const auto& value, const auto& preset) {
    if (value != preset)
      json[key] = value;
  };
  add("mapping", nameOf(use.mapping), nameOf(defaults.mapping));
  add("space", nameOf(use.space), nameOf(defaults.space));
  add("texCoord", use.texCoord, defaults.texCoord);
  add("scale", use.scale, defaults.scale);
  add("offset", use.offset, defaults.offset);
  add("rotation", use.rotation, defaults.rotation);
  add("seed", use.seed, defaults.seed);
  add("blendSharpness", use.blendSharpness, defaults.blendSharpness);
  add("planeSharpness", use.planeSharpness, defaults.planeSharpness);
  add("contrast", use.contrast, defaults.contrast);
  add("tileRotation", use.tileRotation, defaults.tileRotation);
  add("impacts", use.impacts, defaults.impacts);
  add("pointProcess", nameOf(use.pointProcess), nameOf(defaults.pointProcess));
  if (use.mix != defaults.mix)
    json["mix"] = describeMix(use.mix);
  return json;
}

} // namespace lichen
