// SPDX-License-Identifier: MIT
// Layered noises in a file: every fault that the checker must report by its code and the reader
// must reject, what is ignored, and what merging makes of them.
#include "bundle_example.h"
#include "bundle_faults.h"

#include <lichen/bundle_merge.h>
#include <lichen/layered_noise.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>

using namespace lichen;
using example::GlbParts;
using nlohmann::json;

namespace {

const std::vector<std::byte>& soundFile() {
  static const std::vector<std::byte> file = encodeGlb(example::layered()).value();
  return file;
}

json& noiseOf(GlbParts& parts, std::size_t noise) { return parts.extension()["noises"][noise]; }
json& rootOf(GlbParts& parts) { return noiseOf(parts, 0)["layers"]; }

} // namespace

TEST_CASE("a layered noise has no faults, and is read as it was written") {
  CHECK(checkBundle(GlbParts(soundFile()).join()).empty());
  const Bundle bundle = parseBundle(soundFile(), "layered").value();
  REQUIRE(bundle.noises.size() == 3);
  CHECK(bundle.noises[0] == example::layered().bundle.noises[0]);
  CHECK(bundle.noises[0].layers->others == std::vector<std::size_t>{1});
  CHECK(layersOf(bundle, 0) == std::vector<std::size_t>{0, 1});
  CHECK(layersOf(bundle, 1) == std::vector<std::size_t>{1});
}

TEST_CASE("every fault of layers is found") {
  example::checkFaults(
      soundFile(),
      {
          {"a list", "type", [](GlbParts& p) { rootOf(p) = json::array(); }},
          {"no index map", "required", [](GlbParts& p) { rootOf(p).erase("index"); }},
          {"no such index map", "noise-index", [](GlbParts& p) { rootOf(p)["index"] = 3; }},
          {"no proportion", "required", [](GlbParts& p) { rootOf(p).erase("proportion"); }},
          {"all above", "range", [](GlbParts& p) { rootOf(p)["proportion"] = 1; }},
          {"no softness", "range", [](GlbParts& p) { rootOf(p)["softness"] = 0; }},
          {"one side", "required", [](GlbParts& p) { rootOf(p).erase("above"); }},
          {"a side of text", "type", [](GlbParts& p) { rootOf(p)["above"] = "1"; }},
          {"no such side", "noise-index", [](GlbParts& p) { rootOf(p)["above"] = 9; }},
          {"one layer twice", "layer-duplicate", [](GlbParts& p) { rootOf(p)["above"] = 1; }},
          {"itself twice", "layer-duplicate", [](GlbParts& p) { rootOf(p)["below"] = 0; }},
          {"without itself", "layer-self", [](GlbParts& p) { rootOf(p)["above"] = 2; }},
          {"four nodes", "layer-count",
           [](GlbParts& p) {
             for (int nodes = 1; nodes < 4; ++nodes) {
               const json inner = rootOf(p);
               rootOf(p)["below"] = inner;
             }
           }},
          {"layered layer", "layer-fit",
           [](GlbParts& p) {
             noiseOf(p,
                     1)["layers"] = {{"index", 2}, {"proportion", 0.5}, {"below", 1}, {"above", 2}};
           }},
          {"itself as the index map", "layer-fit", [](GlbParts& p) { rootOf(p)["index"] = 0; }},
          {"tiles of another size", "layer-fit",
           [](GlbParts& p) { noiseOf(p, 1)["tileSize"] = 2; }},
          {"other channels", "layer-fit",
           [](GlbParts& p) { noiseOf(p, 1)["maps"][0]["channels"] = {"roughness"}; }},
          {"a height", "layer-fit",
           [](GlbParts& p) {
             for (std::size_t layer = 0; layer < 2; ++layer) {
               noiseOf(p, layer)["maps"][0]["target"] = "height";
               noiseOf(p, layer)["maps"][0]["channels"] = {"height"};
             }
           }},
          {"on a surface", "material-mapping",
           [](GlbParts& p) { p.use(0)["mapping"] = "surface"; }},
      });
}

TEST_CASE("quilting is refused as a layer, first or later, with its method in the message") {
  BundleFile file = example::layered();
  Bundle& bundle = file.bundle;
  const Bundle quilting = example::smallestQuilting().bundle;
  Noise noise = quilting.noises[0];
  noise.maps.resize(1);
  noise.maps[0].target = MapTarget::occlusionRoughnessMetallic;
  noise.maps[0].channels = {MapChannel::occlusion};
  auto& map = noise.maps[0].as<QuiltingMap>();
  map.image += bundle.tables.size();
  map.cells += bundle.tables.size();
  bundle.tables.insert(bundle.tables.end(), quilting.tables.begin(), quilting.tables.begin() + 2);
  bundle.noises.push_back(noise);
  const std::vector<std::byte> sound = encodeGlb(file).value();
  constexpr std::size_t kQuilting = 3;
  for (const bool isFirst : {false, true}) {
    GlbParts parts(sound);
    rootOf(parts)["above"] = kQuilting;
    rootOf(parts)["below"] = isFirst ? 1 : 0;
    if (isFirst) {
      noiseOf(parts, kQuilting)["layers"] = rootOf(parts);
      noiseOf(parts, 0).erase("layers");
    }
    const std::vector<Finding> findings = checkBundle(parts.join());
    CHECK(std::ranges::any_of(findings, [&](const Finding& each) {
      return each.code == "layer-fit" &&
             each.message ==
                 "the noise \"bricks\" has the method quilting, which layers do not "
                 "take; expected tiling, texton, local-random-phase or multiple-kernels";
    }));
  }
}

TEST_CASE("a noise with a layer that is ignored shows its first layer alone") {
  GlbParts parts(soundFile());
  noiseOf(parts, 1)["revision"] = 99;
  const Bundle bundle = parseBundle(parts.join(), "layered").value();
  REQUIRE(bundle.noises.size() == 2);
  CHECK(!bundle.noises[0].layers);
  const std::vector<Finding> findings = checkBundle(parts.join());
  CHECK(std::ranges::any_of(findings,
                            [](const Finding& each) { return each.code == "layer-ignored"; }));
}

TEST_CASE("merging and placing keep the layers of a noise") {
  const Bundle layered = parseBundle(soundFile(), "layered").value();
  Bundle plain = example::smallestKernels().bundle;
  plain.materialNames = {"plain"};
  const std::vector<NamedBundle> inputs{{"a", plain}, {"b", layered}};
  const Bundle merged = mergeBundles(inputs).value().bundle;
  REQUIRE(merged.noises.size() == 4);
  CHECK(merged.noises[1].layers->others == std::vector<std::size_t>{2});
  CHECK(merged.noises[1].layers->nodes[0].index == 3);
  CHECK(merged.materials.size() == 2); // the other layer and the index map have none
  CHECK(merged.materials[1]->noise == 1);

  Bundle scene;
  const std::size_t place = placeNoise(scene, layered, 0, {});
  REQUIRE(scene.noises.size() >= 2);
  CHECK(scene.noises[place].layers->nodes.size() == 1);
  CHECK(layersFault(scene, place).empty());
  CHECK(placeNoise(scene, layered, 0, {}) == place);
}
