// SPDX-License-Identifier: MIT
// applyNoise(): what the command line checks before it calls it.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/apply_noise.h>
#include <lichen/files.h>

#include <catch2/catch.hpp>

#include <exhausted_memory.h>
#include <temporary_folder.h>

using namespace lichen;

namespace {

Bundle bundleOfTiles() {
  const MapExemplar map = test::threeMaterials(64, 64, 1);
  TilingOptions options;
  options.gaussian = GaussianOnly::yes;
  return test::bundleOf(bakeTiling("moss", {&map, 1}, options));
}

/// A scene with two materials.
GltfScene scene(const TemporaryFolder& folder) {
  const std::string text = R"({"asset": {"version": "2.0"}, "materials": [{}, {"name": "wall"}]})";
  REQUIRE(replaceFile(folder / "scene.gltf", std::as_bytes(std::span(text))));
  return GltfScene::open(folder / "scene.gltf").value();
}

} // namespace

TEST_CASE("a noise is applied to materials, unless it is not there or does not fit the mapping") {
  const TemporaryFolder folder;
  const Bundle bundle = bundleOfTiles();
  ApplyOptions options;
  options.materials = {"wall"};
  options.use.mapping = Mapping::triplanar;
  const auto refused = [&](std::size_t noise) {
    GltfScene into = scene(folder);
    const Result<NoiseOnScene> applied = applyNoise(into, bundle, noise, options);
    return !applied && applied.error().kind == ErrorKind::usage;
  };
  GltfScene into = scene(folder);
  const Result<NoiseOnScene> applied = applyNoise(into, bundle, 0, options);
  REQUIRE(applied);
  CHECK(applied.value().noise.name == "moss");
  CHECK(applied.value().materials == std::vector<std::string>{into.materialTitle(1)});
  CHECK(!into.document()["materials"][0].contains("extensions"));
  CHECK(refused(1));
  options.use.mapping = Mapping::surface; // tiles need texture coordinates or planes
  CHECK(refused(0));
}

TEST_CASE("applying a noise reports exhausted memory") {
  const TemporaryFolder folder;
  const Bundle bundle = bundleOfTiles();
  ApplyOptions options;
  options.materials = {"all"};
  options.use.mapping = Mapping::triplanar;
  for (const std::size_t leastBytes : {std::size_t(0), std::size_t(4096)}) { // 4096: of tables
    INFO(leastBytes);
    GltfScene into = scene(folder);
    const Result<NoiseOnScene> applied = [&] {
      const test::ExhaustedMemory memory(1, leastBytes);
      return applyNoise(into, bundle, 0, options);
    }();
    REQUIRE(!applied);
    CHECK(applied.error().kind == ErrorKind::resources);
  }
}
