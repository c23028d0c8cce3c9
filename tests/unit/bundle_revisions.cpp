// SPDX-License-Identifier: MIT
// The reader ignores noises whose method or revision it does not know, and reads the others.
#include "bundle_example.h"
#include "bundle_surgery.h"

#include <catch2/catch.hpp>

using namespace lichen;
using example::GlbParts;
using nlohmann::json;

namespace {

/// The file of everyMap(), with its first noise as if written by a later version.
GlbParts laterFile() {
  GlbParts parts(encodeGlb(example::everyMap()).value());
  json& noise = parts.extension()["noises"][0];
  noise = {
      {"name", noise["name"]}, {"method", "tiling"}, {"revision", 2}, {"maps", {{"spell", 7}}}};
  parts.use(0) = {{"noise", 0}, {"mapping", "surface"}, {"scale", "large"}};
  parts.setTableWord(0, 12, 131); // vkFormat: VK_FORMAT_BC1_RGB_UNORM_BLOCK
  parts.extension()["tables"][1] = {{"bufferView", 1000}};
  return parts;
}

} // namespace

TEST_CASE("a noise of a later revision is ignored with its maps, tables and materials") {
  const std::vector<std::byte> file = laterFile().join();
  const Bundle all = example::everyMap().bundle;
  const auto parsed = parseBundle(file, "later.glb");
  if (!parsed)
    FAIL(parsed.error().message);
  const Bundle& bundle = parsed.value();
  REQUIRE(bundle.ignoredNoises.size() == 1);
  CHECK(bundle.ignoredNoises[0].place == 0);
  CHECK(bundle.ignoredNoises[0].name == "felt");
  CHECK(bundle.ignoredNoises[0].revision == 2);
  CHECK(bundle.ignoredNoises[0].materials == std::vector<std::size_t>{0});
  REQUIRE(bundle.noises.size() == 1);
  CHECK(bundle.noises[0].name == "moss");
  REQUIRE(bundle.materials.size() == 2);
  CHECK_FALSE(bundle.materials[0].has_value());
  REQUIRE(bundle.materials[1].has_value());
  CHECK(bundle.materials[1]->noise == 0);
  CHECK(bundle.materials[1]->scale == 0.25);
  CHECK(bundle.tables.size() == all.tables.size() - 2);
  for (std::size_t m = 0; m < all.noises[1].maps.size(); ++m) {
    const NoiseMap& expected = all.noises[1].maps[m];
    const NoiseMap& map = bundle.noises[0].maps[m];
    std::vector<std::size_t> tables, expectedTables;
    visitTables(map, [&](std::size_t table) { tables.push_back(table); });
    visitTables(expected, [&](std::size_t table) { expectedTables.push_back(table); });
    REQUIRE(tables.size() == expectedTables.size());
    for (std::size_t t = 0; t < tables.size(); ++t)
      CHECK(bundle.tables[tables[t]].texels == all.tables[expectedTables[t]].texels);
  }
}

TEST_CASE("a noise of an unknown method is ignored, whatever its revision") {
  GlbParts parts = laterFile();
  parts.extension()["noises"][0]["method"] = "magic";
  SECTION("revision 1") { parts.extension()["noises"][0]["revision"] = 1; }
  SECTION("a later revision") {}
  SECTION("no revision") { parts.extension()["noises"][0].erase("revision"); }
  const std::vector<std::byte> file = parts.join();
  const auto parsed = parseBundle(file, "unknown.glb");
  REQUIRE(parsed.ok());
  REQUIRE(parsed.value().ignoredNoises.size() == 1);
  CHECK(parsed.value().ignoredNoises[0].method == "magic");
  CHECK_FALSE(parsed.value().materials[0].has_value());
  CHECK(parsed.value().noises.size() == 1);
  const std::vector<Finding> findings = checkBundle(file);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].severity == Finding::Severity::warning);
  CHECK(findings[0].code == "noise-method");
  CHECK(findings[0].pointer == "/extensions/LICHEN_materials_exemplar_noise/noises/0/method");
  CHECK(findings[0].message.starts_with("method \"magic\"; this version does not know it"));
}

TEST_CASE("the checker's only warning on a later revision states the known one") {
  const std::vector<Finding> findings = checkBundle(laterFile().join());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].severity == Finding::Severity::warning);
  CHECK(findings[0].code == "noise-revision");
  CHECK(findings[0].pointer == "/extensions/LICHEN_materials_exemplar_noise/noises/0/revision");
  CHECK(findings[0].message.starts_with("revision 2 of tiling; this version knows 1"));
}

TEST_CASE("a file with only later revisions has no noise") {
  GlbParts parts = laterFile();
  parts.extension()["noises"][1]["revision"] = 2147483647;
  const auto parsed = parseBundle(parts.join(), "later.glb");
  REQUIRE(parsed.ok());
  CHECK(parsed.value().noises.empty());
  CHECK(parsed.value().tables.empty());
  REQUIRE(parsed.value().ignoredNoises.size() == 2);
  CHECK(parsed.value().ignoredNoises[1].place == 1);
  CHECK_FALSE(parsed.value().materials[1].has_value());
}

TEST_CASE("faults of other noises are found beside a noise of a later revision") {
  GlbParts parts = laterFile();
  SECTION("in a map") { parts.map(1, 0)["gaussian"] = 1000; }
  SECTION("in a table") { parts.setTableWord(2, 12, 0); }
  SECTION("in a use") { parts.use(1)["noise"] = 2; }
  SECTION("in a revision that no integer holds") {
    parts.extension()["noises"][1]["revision"] = 4294967296;
  }
  CHECK_FALSE(parseBundle(parts.join(), "broken.glb").ok());
}
