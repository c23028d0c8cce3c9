// SPDX-License-Identifier: MIT
// The lattice against the extension's published test vectors, from an independent implementation.
#include "checkout_paths.h"

#include <lichen/lattice.h>
#include <lichen/tiling_map.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace lichen;

namespace {

const nlohmann::json& vectors() {
  static const nlohmann::json file = [] {
    std::ifstream stream(sourcePath("docs/gltf_extension/test_vectors.json"));
    return nlohmann::json::parse(stream);
  }();
  return file;
}

Grain grainOf(const nlohmann::json& vector) {
  return vector.contains("grain") ? grainFrom(vector["grain"].get<std::string>()).value()
                                  : Grain::none;
}

} // namespace

TEST_CASE("the specification shows the values that the code computes") {
  std::ifstream stream(sourcePath("docs/gltf_extension/README.md"));
  const std::string page((std::istreambuf_iterator<char>(stream)), {});
  const auto shows = [&page](const std::string& what, std::initializer_list<std::uint32_t> values) {
    std::string list;
    for (const std::uint32_t value : values)
      list += (list.empty() ? "" : ", ") + std::to_string(value);
    INFO(what << " " << list);
    const std::size_t row = page.find("| " + what + " |");
    REQUIRE(row != std::string::npos);
    CHECK(page.substr(row, page.find('\n', row) - row).find(list) != std::string::npos);
  };
  const auto triple = pcg3d({0, 1, 2});
  const auto offset = tileOffsetTexels(~0u, ~0u, latticeSeed(1, 0), 256, 256);
  shows("`pcg(0)`, `pcg(1)`, `pcg(0xffffffff)`", {pcg(0), pcg(1), pcg(~0u)});
  shows("`pcg3d(0, 1, 2)`", {triple[0], triple[1], triple[2]});
  shows("`latticeSeed(1, 0)`", {latticeSeed(1, 0)});
  shows("`vertexHash(-1, -1, latticeSeed(1, 0))`", {vertexHash(~0u, ~0u, latticeSeed(1, 0))});
  shows("`tileOffset(-1, -1, latticeSeed(1, 0), 256, 256)`", {offset[0], offset[1]});
}

TEST_CASE("the specification describes every property of the schemas") {
  std::ifstream pageStream(sourcePath("docs/gltf_extension/README.md"));
  const std::string page((std::istreambuf_iterator<char>(pageStream)), {});
  const std::string folder = sourcePath("docs/gltf_extension/schema/");
  for (const char* kind : {"glTF", "table", "noise", "texton", "map", "material"}) {
    std::ifstream stream(folder + kind + ".LICHEN_materials_exemplar_noise.schema.json");
    const nlohmann::json properties = nlohmann::json::parse(stream).at("properties");
    for (const auto& [name, property] : properties.items())
      if (name != "extensions" && name != "extras") {
        INFO(kind << " " << name);
        CHECK(page.find("| **" + name + "** |") != std::string::npos);
      }
  }
}

TEST_CASE("the hashes and seeds equal the published test vectors") {
  for (const nlohmann::json& v : vectors()["pcg"])
    CHECK(pcg(v["value"]) == v["hash"].get<std::uint32_t>());
  for (const nlohmann::json& v : vectors()["pcg3d"])
    CHECK(pcg3d(v["value"].get<std::array<std::uint32_t, 3>>()) ==
          v["hash"].get<std::array<std::uint32_t, 3>>());
  for (const nlohmann::json& v : vectors()["latticeSeed"])
    CHECK(latticeSeed(v["seed"], v["plane"]) == v["word"].get<std::uint32_t>());
}

TEST_CASE("hashes of vertices equal the published test vectors") {
  CHECK(vectors()["vertexHash"].size() > 20);
  for (const nlohmann::json& v : vectors()["vertexHash"]) {
    const auto vertex = v["vertex"].get<std::array<std::int32_t, 2>>();
    CHECK(vertexHash(std::uint32_t(vertex[0]), std::uint32_t(vertex[1]),
                     latticeSeed(v["seed"], v["plane"])) == v["hash"].get<std::uint32_t>());
  }
}

TEST_CASE("tile offsets equal the published test vectors") {
  for (const nlohmann::json& v : vectors()["tileOffset"]) {
    const auto vertex = v["vertex"].get<std::array<std::int32_t, 2>>();
    const auto size = v["size"].get<std::array<std::uint32_t, 2>>();
    CHECK(tileOffsetTexels(std::uint32_t(vertex[0]), std::uint32_t(vertex[1]),
                           latticeSeed(v["seed"], v["plane"]), size[0],
                           size[1]) == v["texels"].get<std::array<std::uint32_t, 2>>());
  }
}

TEST_CASE("tile rotations equal the published test vectors") {
  CHECK(vectors()["tileRotation"].size() > 20);
  for (const nlohmann::json& v : vectors()["tileRotation"]) {
    const auto vertex = v["vertex"].get<std::array<std::int32_t, 2>>();
    CHECK(tileQuarterTurns(std::uint32_t(vertex[0]), std::uint32_t(vertex[1]),
                           latticeSeed(v["seed"], v["plane"]),
                           v["tileRotation"]) == v["quarterTurns"].get<std::uint32_t>());
  }
}

TEST_CASE("tile origins and periodic lattices equal the published test vectors") {
  for (const nlohmann::json& v : vectors()["latticeCell"]) {
    const auto tile = v["tile"].get<std::array<std::int64_t, 2>>();
    const Grain grain = grainOf(v);
    INFO("tile " << tile[0] << ", " << tile[1] << ", grain " << nameOf(grain));
    CHECK(latticeCell(tile[0], tile[1], grain) == v["cell"].get<std::array<std::int32_t, 2>>());
  }
  for (const nlohmann::json& v : vectors()["periodicLattice"]) {
    const auto tiles = v["tiles"].get<std::array<double, 2>>();
    const Grain grain = grainOf(v);
    INFO("period " << tiles[0] << ", " << tiles[1] << ", grain " << nameOf(grain));
    const Lattice lattice = periodicLattice(tiles[0], tiles[1], grain);
    CHECK(lattice.periodColumns == v["columns"].get<std::int32_t>());
    CHECK(lattice.periodRows == v["rows"].get<std::int32_t>());
  }
}
