// SPDX-License-Identifier: MIT
// Bundles -> one bundle with renumbered tables and unique names.
#include "extension_writer.h"

#include <lichen/bundle_merge.h>
#include <lichen/layered_noise.h>

#include <algorithm>
#include <set>
#include <utility>

namespace lichen {
namespace {

/// `name`, or if that is taken, the first free one of name-2, name-3, ...
std::string uniqueName(const std::string& name, std::set<std::string>& taken) {
  std::string unique = name;
  for (std::size_t number = 2; !taken.insert(unique).second; ++number)
    unique = name + "-" + std::to_string(number);
  return unique;
}

bool isSameImage(const Table& a, const Table& b) {
  return a.format == b.format && a.width == b.width && a.height == b.height && a.depth == b.depth &&
         a.mipLevels == b.mipLevels && a.texels == b.texels;
}

/// The index of a table in `all`; appends the table if `all` has no equal one.
std::size_t placeTable(std::vector<Table>& all, const Table& table, const std::string& name) {
  const auto same = std::find_if(all.begin(), all.end(),
                                 [&](const Table& other) { return isSameImage(other, table); });
  if (same != all.end())
    return std::size_t(same - all.begin());
  all.push_back(table);
  all.back().name = name;
  return all.size() - 1;
}

/// Adds the tables of a noise of `from` to `into`, and renumbers the noise's indices. `name` is the
/// noise's new name.
void placeTables(Bundle& into, const Bundle& from, Noise& noise, const std::string& name) {
  const auto placed = [&](std::size_t index) {
    const Table& table = from.tables[index];
    const bool isNamedAfterNoise = table.name.starts_with(noise.name + ".");
    return placeTable(into.tables, table,
                      isNamedAfterNoise ? name + table.name.substr(noise.name.size()) : table.name);
  };
  for (NoiseMap& map : noise.maps)
    visitTables(map, [&](std::size_t& table) { table = placed(table); });
}

/// Whether only layered noises use a noise, and no material.
bool isOnlyLayer(const Bundle& bundle, std::size_t index) {
  if (std::ranges::any_of(bundle.materials, [&](const std::optional<MaterialNoise>& material) {
        return material && material->noise == index;
      }))
    return false;
  bool isLayer = false;
  for (const Noise& noise : bundle.noises)
    visitLayerNoises(noise, [&](std::size_t other) { isLayer = isLayer || other == index; });
  return isLayer;
}

/// Merges bundles one after the other.
class Merger {
public:
  Result<void> add(const NamedBundle& input);
  [[nodiscard]] MergedBundle finish() && { return std::move(merged_); }

private:
  void addNoise(const NamedBundle& input, std::size_t index);

  MergedBundle merged_;
  std::set<std::string> noiseNames_, materialNames_;
};

void Merger::addNoise(const NamedBundle& input, std::size_t index) {
  Bundle& bundle = merged_.bundle;
  Noise noise = input.bundle.noises[index];
  const std::size_t first = bundle.noises.size() - index; // of this input
  visitLayerNoises(noise, [&](std::size_t& other) { other += first; });
  const std::string name = uniqueName(noise.name, noiseNames_);
  if (name != noise.name)
    merged_.notes.push_back(input.file + ": noise '" + noise.name + "' is named '" + name +
                            "', since another has that name");
  placeTables(bundle, input.bundle, noise, name);

  noise.name = name;
  const std::string original = input.bundle.noises[index].name;
  if (isOnlyLayer(input.bundle, index)) {
    bundle.noises.push_back(std::move(noise));
    return;
  }
  MaterialNoise use;
  std::string materialName = name;
  std::size_t users = 0;
  for (std::size_t m = 0; m < input.bundle.materials.size(); ++m) {
    const std::optional<MaterialNoise>& material = input.bundle.materials[m];
    if (!material || material->noise != index || users++ > 0)
      continue;
    use = *material;
    if (const std::string& own = input.bundle.materialNames[m]; !own.empty() && own != original)
      materialName = own;
  }
  if (users > 1)
    merged_.notes.push_back(input.file + ": " + std::to_string(users) + " materials use noise '" +
                            original + "'; the first one's parameters are kept");
  use.noise = bundle.noises.size();
  if (use.mix.source == MixSource::texture) {
    merged_.notes.push_back(input.file + ": noise '" + original +
                            "': the mask of its mix is not copied; its first step is shown");
    use.mix = {};
  }
  bundle.noises.push_back(std::move(noise));
  bundle.materials.emplace_back(use);
  bundle.materialNames.push_back(uniqueName(materialName, materialNames_));
  if (bundle.materialNames.back() != materialName)
    merged_.notes.push_back(input.file + ": material '" + materialName + "' is named '" +
                            bundle.materialNames.back() + "', since another has that name");
}

Result<void> Merger::add(const NamedBundle& input) {
  if (!input.bundle.ignoredNoises.empty()) {
    const IgnoredNoise& ignored = input.bundle.ignoredNoises.front();
    return Error{ErrorKind::badInput, input.file + ": noise '" + ignored.name + "' has " +
                                          ignored.reason() +
                                          "; merge it with the version of "
                                          "lichen that wrote it"};
  }
  if (input.bundle.noises.empty())
    return Error{ErrorKind::badInput,
                 input.file + ": has no noise; expected a bundle with at least one"};
  for (std::size_t n = 0; n < input.bundle.noises.size(); ++n)
    addNoise(input, n);
  return {};
}

} // namespace

std::size_t placeNoise(Bundle& into, const Bundle& from, std::size_t index,
                       std::set<std::string> taken) {
  Noise noise = from.noises[index];
  visitLayerNoises(noise, [&](std::size_t& other) {
    other = placeNoise(into, from, other, taken);
    taken.insert(into.noises[other].name);
  });
  const std::size_t tablesBefore = into.tables.size();
  const std::string name = uniqueName(noise.name, taken);
  placeTables(into, from, noise, name);
  if (into.tables.size() == tablesBefore) { // a noise with new tables cannot be a duplicate
    const auto same = std::find_if(into.noises.begin(), into.noises.end(), [&](const Noise& other) {
      noise.name = other.name; // ignores these two in the comparison
      noise.preparation = other.preparation;
      return noise == other;
    });
    if (same != into.noises.end())
      return std::size_t(same - into.noises.begin());
  }
  noise.name = name;
  noise.preparation = from.noises[index].preparation;
  into.noises.push_back(std::move(noise));
  return into.noises.size() - 1;
}

namespace {

/// A tree numbered as a file has it.
struct OrderedLayers {
  std::vector<LayerNode> nodes;
  std::vector<std::size_t> oldNodes;  ///< the number that each node had
  std::vector<std::size_t> layers{0}; ///< the number that each layer had
};

/// Adds a node and those below it, and returns its new number: nodes come before those below them,
/// and the side below before the side above; layers but the first in the same order.
std::size_t orderNode(const std::vector<LayerNode>& nodes, std::size_t node,
                      OrderedLayers& ordered) {
  const std::size_t place = ordered.nodes.size();
  ordered.nodes.push_back(nodes[node]);
  ordered.oldNodes.push_back(node);
  const auto numbered = [&](const LayerSide& side) -> LayerSide {
    if (side.isNode)
      return {true, orderNode(nodes, side.index, ordered)};
    if (side.index == 0)
      return side;
    ordered.layers.push_back(side.index);
    return {false, ordered.layers.size() - 1};
  };
  const LayerSide below = numbered(nodes[node].below);
  const LayerSide above = numbered(nodes[node].above);
  ordered.nodes[place].below = below;
  ordered.nodes[place].above = above;
  return place;
}

} // namespace

Result<Bundle> layerNoises(const std::string& name, std::span<const BundledNoise> layers,
                           std::span<const BundledNoise> indices,
                           const std::vector<LayerNode>& nodes) {
  const auto build = [&]() -> Result<Bundle> {
    Bundle bundle;
    const auto add = [&](const BundledNoise& input, std::string named) {
      Noise noise = input.bundle->noises[input.noise];
      placeTables(bundle, *input.bundle, noise, named);
      noise.name = std::move(named);
      noise.layers.reset();
      noise.preparation = {};
      bundle.noises.push_back(std::move(noise));
      return bundle.noises.size() - 1;
    };
    OrderedLayers ordered;
    orderNode(nodes, 0, ordered);
    NoiseLayers result;
    for (std::size_t layer = 0; layer < ordered.layers.size(); ++layer) {
      const std::size_t place =
          add(layers[ordered.layers[layer]],
              layer == 0 ? name : name + ".layer" + std::to_string(layer + 1));
      if (layer > 0)
        result.others.push_back(place);
    }
    for (std::size_t node = 0; node < ordered.nodes.size(); ++node)
      ordered.nodes[node].index =
          add(indices[ordered.oldNodes[node]], name + ".index" + std::to_string(node + 1));
    result.nodes = std::move(ordered.nodes);
    bundle.noises[0].layers = std::move(result);
    if (const std::string fault = layersFault(bundle, 0); !fault.empty())
      return Error{ErrorKind::usage, fault};
    const BundledNoise& first = layers.front();
    MaterialNoise material;
    for (const std::optional<MaterialNoise>& each : first.bundle->materials)
      if (each && each->noise == first.noise) {
        material = *each;
        break;
      }
    material.noise = 0;
    material.mix = {};
    bundle.materials.emplace_back(material);
    bundle.materialNames.push_back(name);
    return bundle;
  };
  return withinMemory([] { return "not enough memory to layer the noises"; }, build);
}

Result<MergedBundle> mergeBundles(std::span<const NamedBundle> inputs) {
  return withinMemory([] { return "not enough memory to merge the bundles"; },
                      [&]() -> Result<MergedBundle> {
                        Merger merger;
                        for (const NamedBundle& input : inputs)
                          if (Result<void> added = merger.add(input); !added)
                            return added.error();
                        return std::move(merger).finish();
                      });
}

} // namespace lichen
