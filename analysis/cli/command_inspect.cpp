// SPDX-License-Identifier: MIT
// lichen inspect: shows the contents of a bundle and their cost.
#include "command.h"
#include "methods/method_command.h"
#include "noise_choice.h"
#include "options.h"
#include "table_words.h"

#include <lichen/bundle_files.h>
#include <lichen/counted.h>
#include <lichen/layered_noise.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

namespace lichen::cli {
namespace {

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string bundle;
};

const MethodCommand& commandOf(const Noise& noise) { return cli::commandOf(noise.method()); }

int fetchesPerPixel(const Bundle& bundle, std::size_t noise, const NoiseMap& map) {
  const Noise& described = bundle.noises[noise];
  return commandOf(described).fetches(described, map, materialOf(bundle, noise));
}

/// Returns the bits per channel of the image that the shader samples.
int bitsOf(const Bundle& bundle, std::size_t noise, const NoiseMap& map) {
  return formatName(bundle.tables[commandOf(bundle.noises[noise]).imageOf(map)].format).bits;
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

// ---- JSON --------------------------------------------------------------------------------------

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
            {"bits", bitsOf(bundle, noise, map)},
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
                      {"format", formatName(table.format).name},
                      {"width", table.width},
                      {"height", table.height},
                      {"depth", table.depth},
                      {"mipLevels", table.mipLevels},
                      {"bytes", table.texels.size()}});
  return {{"file", file},     {"bytesOnDisk", diskBytes}, {"bytesOnGpu", texelBytes(bundle)},
          {"noises", noises}, {"ignoredNoises", ignored}, {"tables", tables}};
}

// ---- text: the same, without what only a program asks for --------------------------------------

std::string size(std::size_t bytes) {
  constexpr double kKibi = 1024.0;
  const double kib = double(bytes) / kKibi;
  return kib < kKibi ? fmt::format("{:.1f} KiB", kib) : fmt::format("{:.1f} MiB", kib / kKibi);
}

/// Returns "mix along (0, 0) to (0, 1)".
std::string mixOf(const MixWeight& mix) {
  switch (mix.source) {
  case MixSource::constant:
    return fmt::format("mix {:g}", mix.weight);
  case MixSource::direction:
    return fmt::format("mix along ({:g}) to ({:g})", fmt::join(mix.start, ", "),
                       fmt::join(mix.end, ", "));
  case MixSource::texture:
    return fmt::format("mix by channel {} of texture {}", mix.channel, mix.texture);
  case MixSource::vertexColor:
    return fmt::format("mix by channel {} of COLOR_{}", mix.channel, mix.colorSet);
  }
  return "";
}

/// Returns mapping and seed, which always matter, and the parameters that differ from the format's
/// defaults.
std::string parametersOf(const MaterialNoise& use) {
  const MaterialNoise defaults;
  std::string text =
      fmt::format("{}{}, seed {}", nameOf(use.mapping),
                  use.space == NoiseSpace::object ? " in object space" : "", use.seed);
  const auto add = [&](bool isDefault, const std::string& parameter) {
    text += isDefault ? "" : ", " + parameter;
  };
  add(use.texCoord == defaults.texCoord, fmt::format("texCoord {}", use.texCoord));
  add(use.scale == defaults.scale, fmt::format("scale {:g}", use.scale));
  add(use.offset == defaults.offset, fmt::format("offset {:g},{:g}", use.offset[0], use.offset[1]));
  add(use.rotation == defaults.rotation, fmt::format("rotation {:g}", use.rotation));
  add(use.blendSharpness == defaults.blendSharpness,
      fmt::format("sharpness {:g}", use.blendSharpness));
  add(use.planeSharpness == defaults.planeSharpness,
      fmt::format("plane sharpness {:g}", use.planeSharpness));
  add(use.contrast == defaults.contrast, fmt::format("contrast {:g}", use.contrast));
  add(use.tileRotation == defaults.tileRotation,
      fmt::format("tile rotation in {} directions", use.tileRotation));
  add(use.impacts == defaults.impacts, fmt::format("{:g} impacts", use.impacts));
  add(use.pointProcess == defaults.pointProcess, std::string(nameOf(use.pointProcess)));
  add(use.mix == defaults.mix, mixOf(use.mix));
  return text;
}

void sayMap(const SharedOptions& shared, const Bundle& bundle, std::size_t noise,
            const NoiseMap& map) {
  std::vector<std::string_view> channels;
  for (const MapChannel channel : map.channels)
    channels.push_back(nameOf(channel));
  const auto [width, height] = exemplarSize(bundle, bundle.noises[noise], map);
  say(shared, fmt::format("  {}: {}", nameOf(map.target), fmt::join(channels, ", ")));
  say(shared, fmt::format("    {} x {}, {} bits, {}; {} fetches per pixel", width, height,
                          bitsOf(bundle, noise, map), nameOf(map.encoding),
                          fetchesPerPixel(bundle, noise, map)));
  say(shared, "    " + statisticsOf(map.mean, map.covariance));
  for (const std::string& line : commandOf(bundle.noises[noise]).linesOf(bundle, map))
    say(shared, "    " + line);
}

void sayNoise(const SharedOptions& shared, const Bundle& bundle, std::size_t index) {
  const Noise& noise = bundle.noises[index];
  say(shared, "");
  say(shared, "noise " + noise.name);
  say(shared,
      fmt::format("  {}, revision {}, {:g} m wide, {}{} fetches per pixel and plane",
                  nameOf(noise.method()), revisionOf(noise.method()), noise.tileSizeMetres,
                  commandOf(noise).fetchesVary() ? "about " : "", fetchesPerPixel(bundle, index)));
  for (const std::string& line : commandOf(noise).linesOf(noise, materialOf(bundle, index)))
    say(shared, "  " + line);
  if (noise.layers) {
    say(shared, fmt::format("  layers: {}", fmt::join(layerNames(bundle, index), ", ")));
    for (const LayerNode& node : noise.layers->nodes)
      say(shared, fmt::format("    {}: {:.3g} of the area above, softness {:g}",
                              bundle.noises[node.index].name, node.proportion, node.softness));
  }
  for (const NoiseMap& map : noise.maps)
    sayMap(shared, bundle, index, map);
  for (std::size_t m = 0; m < bundle.materials.size(); ++m)
    if (bundle.materials[m] && bundle.materials[m]->noise == index) {
      say(shared, fmt::format("  material {} {}", m, bundle.materialNames[m]));
      say(shared, "    " + parametersOf(*bundle.materials[m]));
    }
}

void sayTables(const SharedOptions& shared, const std::vector<Table>& tables) {
  say(shared, "");
  say(shared, "tables");
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const Table& table = tables[t];
    const std::string extent =
        table.depth > 0 ? fmt::format("{} x {} x {}", table.width, table.height, table.depth)
                        : fmt::format("{} x {}", table.width, table.height);
    say(shared, fmt::format("  {:<3} {:<10} {:<13} {:>7} {:>10}  {}", t,
                            formatName(table.format).name, extent, counted(table.mipLevels, "mip"),
                            size(table.texels.size()), table.name));
  }
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
  if (arguments.shared.json) {
    printLine(toText(describe(bundle, arguments.bundle, diskBytes.value())));
    return kDone;
  }
  say(arguments.shared, arguments.bundle);
  say(arguments.shared,
      fmt::format("  {} and {}, {} on disk, {} on the GPU", counted(bundle.noises.size(), "noise"),
                  counted(bundle.tables.size(), "table"), size(diskBytes.value()),
                  size(texelBytes(bundle))));
  for (std::size_t n = 0; n < bundle.noises.size(); ++n)
    sayNoise(arguments.shared, bundle, n);
  for (const IgnoredNoise& noise : bundle.ignoredNoises)
    say(arguments.shared, fmt::format("noise {}: {}", noise.name, noise.reason()));
  sayTables(arguments.shared, bundle.tables);
  return kDone;
}

} // namespace

Runner addInspect(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addText(verb, "BUNDLE", arguments->bundle, "", "A .glb, .gltf or .lichen with noises").required();
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
