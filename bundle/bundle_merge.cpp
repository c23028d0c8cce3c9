// SPDX-License-Identifier: MIT
// Bundles -> one bundle with renumbered tables and unique names.
#include "extension_writer.h"

#include <lichen/bundle_merge.h>

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
         a.mipLevels == b.mipLevels && std::ranges::equal(a.bytes(), b.bytes());
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
  const std::string name = uniqueName(noise.name, noiseNames_);
  if (name != noise.name)
    merged_.notes.push_back(input.file + ": noise '" + noise.name + "' is named '" + name +
                            "', since another has that name");
  placeTables(bundle, input.bundle, noise, name);

  MaterialNoise use;
  std::string materialName = name;
  std::size_t users = 0;
  for (std::size_t m = 0; m < input.bundle.materials.size(); ++m) {
    const std::optional<MaterialNoise>& material = input.bundle.materials[m];
    if (!material || material->noise != index || users++ > 0)
      continue;
    use = *material;
    if (const std::string& own = input.bundle.materialNames[m]; !own.empty() && own != noise.name)
      materialName = own;
  }
  if (users > 1)
    merged_.notes.push_back(input.file + ": " + std::to_string(users) + " materials use noise '" +
                            noise.name + "'; the first one's parameters are kept");
  use.noise = bundle.noises.size();
  if (use.mix.source == MixSource::texture) {
    merged_.notes.push_back(input.file + ": noise '" + noise.name +
                            "': the mask of its mix is not copied; its first step is shown");
    use.mix = {};
  }
  noise.name = name;
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
  const std::size_t tablesBefore = into.tables.size();
  const std::string name = uniqueName(noise.name, taken);
  placeTables(into, from, noise, name);
  if (into.tables.size() == tablesBefore) { // a noise with new tables cannot be a duplicate
    const auto same = std::find_if(into.noises.begin(), into.noises.end(), [&](const Noise& other) {
      noise.name = other.name; // ignores the name in the comparison
      return noise == other;
    });
    if (same != into.noises.end())
      return std::size_t(same - into.noises.begin());
  }
  noise.name = name;
  into.noises.push_back(std::move(noise));
  return into.noises.size() - 1;
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
