// SPDX-License-Identifier: MIT
// lichen inspect: shows the contents of a bundle and their cost.
#include "command.h"
#include "methods/method_command.h"
#include "noise_choice.h"
#include "options.h"

#include <lichen/bundle_files.h>
#include <lichen/layered_noise.h>

#include <nlohmann/json.hpp>

#include <memory>

namespace lichen::cli {
namespace {

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string bundle;
};

/// Bits per channel.
int bitsOf(TexelFormat format) {
  constexpr std::size_t kBitsPerByte = 8;
  return int(kBitsPerByte * texelBytes(format)) / channelCount(format);
}

/// "RG8" for two channels of 8 bits, "R16F" for one of 16-bit floats.
std::string formatName(TexelFormat format) {
  const int bits = bitsOf(format);
  return std::string("RGBA").substr(0, std::size_t(channelCount(format))) + std::to_string(bits) +
         (bits > 8 ? "F" : "");
}

const MethodCommand& commandOf(const Noise& noise) { return cli::commandOf(noise.method()); }

int fetchesPerPixel(const Bundle& bundle, std::size_t noise, const NoiseMap& map) {
  const Noise& described = bundle.noises[noise];
  return commandOf(described).fetches(described, map, materialOf(bundle, noise));
}

/// The sum over all maps and layers, and the index maps.
int fetchesPerPixel(const Bundle& bundle, std::size_t noise) {
  int sum = 0;
  for (const std::size_t layer : layersOf(bundle, noise)) {
    sum += commandOf(bundle.noises[layer]).sharedFetches();
    for (const NoiseMap& map : bundle.noises[layer].maps)
      sum += fetchesPerPixel(bundle, layer, map);
  }
  if (const auto& layers = bundle.noises[noise].layers)
    for (const LayerNode& node : layers->nodes)
      sum += fetchesPerPixel(bundle, node.index, bundle.noises[node.index].maps.front());
  return sum;
}

Json describe(const MixWeight& mix) {
  Json json{{"source", nameOf(mix.source)}};
  switch (mix.source) {
  case MixSource::constant:
    json["weight"] = mix.weight;
    return json;
  case MixSource::direction:
    json["start"] = mix.start;
    json["end"] = mix.end;
    return json;
  case MixSource::texture:
    json["texture"] = mix.texture;
    json["texCoord"] = mix.texCoord;
    break;
  case MixSource::vertexColor:
    json["set"] = mix.colorSet;
    break;
  }
  json["channel"] = mix.channel;
  return json;
}

Json describe(const MaterialNoise& use, std::size_t index, const std::string& name) {
  return {{"index", index},
          {"name", name},
          {"mapping", nameOf(use.mapping)},
          {"space", isInSpace(use.mapping) ? Json(nameOf(use.space)) : Json()},
          {"texCoord", use.texCoord},
          {"scale", use.scale},
          {"offset", use.offset},
          {"rotation", use.rotation},
          {"seed", use.seed},
          {"blendSharpness", use.blendSharpness},
          {"planeSharpness", use.planeSharpness},
          {"contrast", use.contrast},
          {"tileRotation", use.tileRotation},
          {"impacts", use.impacts},
          {"pointProcess", nameOf(use.pointProcess)},
          {"mix", describe(use.mix)}};
}

Json describe(const Bundle& bundle, std::size_t noise, const NoiseMap& map) {
  Json channels = Json::array();
  for (const MapChannel channel : map.channels)
    channels.push_back(nameOf(channel));
  const auto [width, height] = exemplarSize(bundle, bundle.noises[noise], map);
  Json json{{"target", nameOf(map.target)},
            {"channels", channels},
            {"encoding", nameOf(map.encoding)},
            {"width", width},
            {"height", height},
            {"bits", bitsOf(bundle.tables[imageTableOf(map)].format)},
            {"mean", map.mean},
            {"covariance", map.covariance},
            {"fetchesPerPixel", fetchesPerPixel(bundle, noise, map)}};
  commandOf(bundle.noises[noise]).describe(map, json);
  return json;
}

std::vector<std::string> layerNames(const Bundle& bundle, std::size_t noise) {
  std::vector<std::string> names;
  for (const std::size_t layer : layersOf(bundle, noise))
    names.push_back(bundle.noises[layer].name);
  return names;
}

Json describe(const Bundle& bundle, std::size_t index) {
  const Noise& noise = bundle.noises[index];
  Json maps = Json::array();
  for (const NoiseMap& map : noise.maps)
    maps.push_back(describe(bundle, index, map));
  Json materials = Json::array();
  for (std::size_t m = 0; m < bundle.materials.size(); ++m)
    if (bundle.materials[m] && bundle.materials[m]->noise == index)
      materials.push_back(describe(*bundle.materials[m], m, bundle.materialNames[m]));
  Json json{{"name", noise.name},
            {"method", nameOf(noise.method())},
            {"revision", revisionOf(noise.method())},
            {"tileSize", noise.tileSizeMetres},
            {"fetchesPerPixel", fetchesPerPixel(bundle, index)},
            {"maps", maps},
            {"materials", materials}};
  commandOf(noise).describe(noise, json);
  if (noise.layers) {
    Json nodes = Json::array();
    for (const LayerNode& node : noise.layers->nodes)
      nodes.push_back({{"index", bundle.noises[node.index].name},
                       {"proportion", node.proportion},
                       {"softness", node.softness}});
    json["layers"] = {{"noises", layerNames(bundle, index)}, {"nodes", nodes}};
  }
  return json;
}

Json describe(const Bundle& bundle, const std::string& file, std::size_t diskBytes) {
  Json noises = Json::array(), ignored = Json::array(), tables = Json::array();
  for (std::size_t n = 0; n < bundle.noises.size(); ++n)
    noises.push_back(describe(bundle, n));
  for (const IgnoredNoise& noise : bundle.ignoredNoises)
    ignored.push_back({{"name", noise.name},
                       {"method", noise.method},
                       {"revision", noise.revision},
                       {"materials", noise.materials}});
  for (const Table& table : bundle.tables)
    tables.push_back({{"name", table.name},
                      {"format", formatName(table.format)},
                      {"width", table.width},
                      {"height", table.height},
                      {"depth", table.depth},
                      {"mipLevels", table.mipLevels},
                      {"bytes", table.texels.size()}});
  return {{"file", file},     {"bytesOnDisk", diskBytes}, {"bytesOnGpu", texelBytes(bundle)},
          {"noises", noises}, {"ignoredNoises", ignored}, {"tables", tables}};
}

Result<int> run(const Arguments& arguments) {
  const Result<Bundle> read = readBundle(arguments.bundle);
  if (!read)
    return read.error();
  const Bundle& bundle = read.value();
  if (bundle.noises.empty() && bundle.ignoredNoises.empty())
    return noNoiseIn(arguments.bundle);
  const Result<std::size_t> diskBytes = bytesOnDisk(arguments.bundle);
  if (!diskBytes)
    return diskBytes.error();
  const Json json = describe(bundle, arguments.bundle, diskBytes.value());
  if (arguments.shared.json)
    printLine(toText(json));
  for (const std::string& line : linesOf(json))
    say(arguments.shared, line);
  return kDone;
}

} // namespace

Runner addInspect(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addText(verb, "BUNDLE", arguments->bundle, "", "A .glb, .gltf or .lichen with noises").required();
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
