// SPDX-License-Identifier: MIT
// Broken bundles. Each row of bundle_faults.json breaks an example file in one place: `patch` edits
// its JSON (RFC 6902, where $ is the extension's root and @N the extension's use by material N),
// and `words` are [table, offset, value], little-endian words of a table's KTX2 file.
#include "bundle_faults.h"

#include "bundle_example.h"
#include "checkout_paths.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <map>

using namespace lichen;
using example::GlbParts;
using nlohmann::json;

namespace {

const std::map<std::string, BundleFile>& examples() {
  static const std::map<std::string, BundleFile> all{
      {"everyMap", example::everyMap()},
      {"textonMix", example::textonMix()},
      {"layered", example::layered()},
      {"smallestCosines", example::smallestCosines()},
      {"smallestStructure", example::smallestStructure()},
      {"smallestKernels", example::smallestKernels()},
      {"smallestQuilting", example::smallestQuilting()}};
  return all;
}

GlbParts partsOf(const std::string& name) {
  return GlbParts(encodeGlb(examples().at(name)).value());
}

json patched(const json& document, json patch) {
  const std::string extension = "/extensions/LICHEN_materials_exemplar_noise";
  for (json& operation : patch) {
    std::string path = operation["path"];
    if (path[0] == '$')
      path = extension + path.substr(1);
    if (path[0] == '@')
      path = "/materials/" + path.substr(1, 1) + extension + path.substr(2);
    operation["path"] = path;
  }
  return document.patch(patch);
}

} // namespace

TEST_CASE("the example files have no faults before they are inserted, and are read as written") {
  for (const auto& [name, file] : examples()) {
    INFO(name);
    const std::vector<std::byte> glb = encodeGlb(file).value();
    CHECK(checkBundle(GlbParts(glb).join()).empty());
    const Bundle bundle = parseBundle(glb, name).value();
    CHECK(bundle.noises == file.bundle.noises);
  }
}

TEST_CASE("every fault of a bundle is found") {
  std::ifstream stream(sourcePath("tests/unit/bundle_faults.json"));
  const json rows = json::parse(stream);
  CHECK(rows.size() > 300);
  std::map<std::string, GlbParts> sound;
  for (const auto& [name, file] : examples())
    sound.emplace(name, partsOf(name));
  for (const json& row : rows) {
    GlbParts parts = sound.at(row["file"]);
    for (const json& word : row.value("words", json::array()))
      parts.setTableWord(word[0], word[1], word[2]);
    parts.json = patched(parts.json, row.value("patch", json::array()));
    example::checkFault(row["file"].get<std::string>() + ": " + row["what"].get<std::string>(),
                        row["code"], parts);
  }
}

TEST_CASE("lists that are far too long are found") {
  GlbParts mean = partsOf("everyMap");
  mean.map(1, 0)["mean"] = std::vector<double>(100000, 0.5);
  example::checkFault("a mean of 100,000 values", "count", mean);
  GlbParts steps = partsOf("textonMix");
  json& later = steps.map(1, 0)["laterSteps"];
  later = json::array_t(65, later[0]);
  example::checkFault("more steps than there can be", "count", steps);
  GlbParts tables = partsOf("everyMap");
  for (int copies = 0; copies < 4; ++copies)
    tables.extension()["tables"].push_back(tables.extension()["tables"][7]);
  for (int copies = 0; copies < 200; ++copies)
    tables.extension()["tables"].push_back(tables.extension()["tables"][3]);
  example::checkFault("tables that share their bytes", "table-overlap", tables);
}
