// SPDX-License-Identifier: MIT
// The extension's JSON, in the order of the specification's tables.
#include "extension_writer.h"

#include "methods/method_format.h"

namespace lichen {
namespace {

JsonTree describeMap(const NoiseMap& map, const MethodFormat& format) {
  JsonTree json = {{"target", nameOf(map.target)}, {"channels", JsonTree::array()}};
  for (const MapChannel channel : map.channels)
    json["channels"].push_back(nameOf(channel));
  json["encoding"] = nameOf(map.encoding);
  json["mean"] = map.mean;
  json["covariance"] = map.covariance;
  format.writeMap(map, json);
  return json;
}

JsonTree describeMix(const MixWeight& mix) {
  JsonTree json = {{"source", nameOf(mix.source)}};
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

} // namespace

JsonTree describeNoise(const Noise& noise) {
  const MethodFormat& format = formatOf(noise);
  JsonTree json = {{"name", noise.name},
                   {"method", format.name()},
                   {"revision", format.revision()},
                   {"tileSize", noise.tileSizeMetres}};
  format.writeNoise(noise, json);
  json["maps"] = JsonTree::array();
  for (const NoiseMap& map : noise.maps)
    json["maps"].push_back(describeMap(map, format));
  return json;
}

JsonTree describeTable(const Table& table, std::size_t bufferView) {
  JsonTree json = JsonTree::object();
  if (!table.name.empty())
    json["name"] = table.name;
  json["bufferView"] = bufferView;
  json["mimeType"] = "image/ktx2";
  return json;
}

JsonTree describeBundle(const Bundle& bundle, GltfBuilder& builder) {
  JsonTree json = {{"tables", JsonTree::array()}, {"noises", JsonTree::array()}};
  for (const Table& table : bundle.tables)
    json["tables"].push_back(
        describeTable(table, builder.addView(encodeKtx2(table), kTableAlignment)));
  for (const Noise& noise : bundle.noises)
    json["noises"].push_back(describeNoise(noise));
  return json;
}

JsonTree describeMaterialNoise(const MaterialNoise& use) {
  const MaterialNoise defaults;
  JsonTree json = {{"noise", use.noise}};
  if (use.mapping != defaults.mapping)
    json["mapping"] = nameOf(use.mapping);
  if (use.space != defaults.space)
    json["space"] = nameOf(use.space);
  if (use.texCoord != defaults.texCoord)
    json["texCoord"] = use.texCoord;
  if (use.scale != defaults.scale)
    json["scale"] = use.scale;
  if (use.offset != defaults.offset)
    json["offset"] = use.offset;
  if (use.rotation != defaults.rotation)
    json["rotation"] = use.rotation;
  if (use.seed != defaults.seed)
    json["seed"] = use.seed;
  if (use.blendSharpness != defaults.blendSharpness)
    json["blendSharpness"] = use.blendSharpness;
  if (use.planeSharpness != defaults.planeSharpness)
    json["planeSharpness"] = use.planeSharpness;
  if (use.contrast != defaults.contrast)
    json["contrast"] = use.contrast;
  if (use.tileRotation != defaults.tileRotation)
    json["tileRotation"] = use.tileRotation;
  if (use.impacts != defaults.impacts)
    json["impacts"] = use.impacts;
  if (use.pointProcess != defaults.pointProcess)
    json["pointProcess"] = nameOf(use.pointProcess);
  if (use.mix != defaults.mix)
    json["mix"] = describeMix(use.mix);
  return json;
}

} // namespace lichen
