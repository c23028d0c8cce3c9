// SPDX-License-Identifier: MIT
// Any bytes -> parseBundle(), checkBundle() and decodeKtx2(): results satisfy their contract, and
// parsing and checking agree.
#include "contract.h"

#include <lichen/bundle.h>
#include <lichen/bundle_writer.h>
#include <lichen/layered_noise.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace lichen;
using fuzz::isOneLine;
using fuzz::require;

namespace {

bool areFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

void checkTable(const Table& table) {
  require(table.width > 0 && table.height > 0 && table.mipLevels > 0, "an empty table");
  const LevelRange last = levelRange(table, table.mipLevels - 1);
  require(table.texels.size() == last.offset + last.size, "number of texel bytes");
  for (const float value : decodeLevel(table, table.mipLevels - 1))
    require(std::isfinite(value), "a texel that is not finite");
}

void checkLayers(const Bundle& bundle, std::size_t noise) {
  const NoiseLayers& layers = *bundle.noises[noise].layers;
  require(layers.others.size() == layers.nodes.size() && !layers.nodes.empty() &&
              layers.nodes.size() <= LICHEN_MAX_LAYER_NODES,
          "number of layers");
  visitLayerNoises(bundle.noises[noise], [&](std::size_t other) {
    require(other < bundle.noises.size() && other != noise && !bundle.noises[other].layers,
            "a layer or an index map");
  });
  std::vector<int> layerUses(layers.others.size() + 1), nodeUses(layers.nodes.size());
  for (const LayerNode& node : layers.nodes) {
    require(node.proportion > 0.0 && node.proportion < 1.0 && node.softness > 0.0, "a node");
    for (const LayerSide& side : {node.below, node.above}) {
      require(side.index < (side.isNode ? nodeUses : layerUses).size(), "a side");
      ++(side.isNode ? nodeUses : layerUses)[side.index];
    }
  }
  require(nodeUses.front() == 0 && std::ranges::count(nodeUses, 1) + 1 == std::ssize(nodeUses) &&
              std::ranges::count(layerUses, 1) == std::ssize(layerUses),
          "a tree");
  const auto constants =
      std::make_unique<shader::LichenNoiseConstants>(shaderConstants(bundle, noise));
  require(constants->layers.count == layerUses.size(), "layers in the constants");
}

void checkMap(const NoiseMap& map, const Noise& noise, const Bundle& bundle) {
  const std::size_t n = map.channels.size();
  require(n >= 1 && n <= 3, "number of channels");
  require(map.mean.size() == n && map.covariance.size() == n * n, "size of the statistics");
  require(areFinite(map.mean) && areFinite(map.covariance), "a number that is not finite");
  require(map.data.index() == noise.data.index(), "a map of another method than its noise");
  visitTables(
      map, [&](std::size_t table) { require(table < bundle.tables.size(), "index of a table"); });
}

/// The tests of each method provoke each of its errors. Here its constants are made of whatever it
/// has read, and what it has read is written and read again.
void checkConstants(const Bundle& bundle) {
  for (std::size_t n = 0; n < bundle.noises.size(); ++n) {
    const auto constants =
        std::make_unique<shader::LichenNoiseConstants>(shaderConstants(bundle, n));
    for (const shader::LichenMap& map : constants->maps)
      for (const float mean : {map.mean.x, map.mean.y, map.mean.z})
        require(std::isfinite(mean), "a mean that is not finite");
  }
  if (bundle.noises.empty())
    return;
  BundleFile file{bundle, {}, PreviewShape::none, ""};
  file.bundle.materials.clear(); // whose masks are textures of the scene
  file.bundle.materialNames.clear();
  for (std::size_t n = 0; n < bundle.noises.size(); ++n)
    file.bundle.materials.emplace_back(MaterialNoise{})->noise = n;
  file.previews.resize(bundle.noises.size());
  const auto written = encodeGlb(file);
  require(written.ok(), "a bundle that cannot be written again");
  const Result<Bundle> again = parseBundle(written.value(), "written again");
  require(again.ok(), "a bundle that cannot be read again");
  require(again.value().noises == bundle.noises, "noises that change when they are read again");
}

void checkContract(const Bundle& bundle) {
  std::for_each(bundle.tables.begin(), bundle.tables.end(), checkTable);
  for (const Noise& noise : bundle.noises)
    for (const NoiseMap& map : noise.maps)
      checkMap(map, noise, bundle);
  for (std::size_t n = 0; n < bundle.noises.size(); ++n)
    if (bundle.noises[n].layers)
      checkLayers(bundle, n);
  require(bundle.materials.size() == bundle.materialNames.size(), "number of material names");
  for (const std::optional<MaterialNoise>& use : bundle.materials) {
    require(!use || use->noise < bundle.noises.size(), "index of a material's noise");
    require(!use || mappingObstacle(bundle, use->noise, use->mapping).empty(),
            "a mapping that the noise does not support");
    require(!use || takesTileRotation(bundle, use->noise, use->tileRotation),
            "a tile rotation that the noise does not take");
    require(!use || (use->impacts >= kImpactsRange.least && use->impacts <= kImpactsRange.most),
            "number of impacts");
    require(!use || use->mix.source != MixSource::direction ||
                std::hypot(use->mix.end[0] - use->mix.start[0],
                           use->mix.end[1] - use->mix.start[1]) >= kLeastMixLength,
            "a direction without length");
    require(!use || (use->mix.weight >= 0.0 && use->mix.weight <= 1.0), "a weight");
  }
  checkConstants(bundle);
  for (const IgnoredNoise& noise : bundle.ignoredNoises) {
    const std::optional<Method> method = methodFrom(noise.method);
    require(!method || noise.revision > revisionOf(*method), "a known noise that is ignored");
    for (const std::size_t material : noise.materials)
      require(material < bundle.materials.size() && !bundle.materials[material],
              "a material of an ignored noise");
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> file(reinterpret_cast<const std::byte*>(data), size);
  const Result<Table> table = decodeKtx2(file, "file");
  if (table)
    checkTable(table.value());
  else
    require(isOneLine(table.error().message), "an error message that is not one line");

  const Result<Bundle> bundle = parseBundle(file, "file");
  const std::vector<Finding> findings = checkBundle(file);
  const bool hasError = std::any_of(findings.begin(), findings.end(), [](const Finding& f) {
    return f.severity == Finding::Severity::error;
  });
  require(bundle.ok() == !hasError, "reading and checking disagree");
  for (const Finding& finding : findings)
    require(!finding.code.empty() && isOneLine(finding.message), "a finding without a message");
  if (bundle)
    checkContract(bundle.value());
  else
    require(isOneLine(bundle.error().message), "an error message that is not one line");
  return 0;
}
