// SPDX-License-Identifier: MIT
// Layered noises in a file: what they read as, which layers are refused or ignored, and what
// merging makes of them. Faults are rows of bundle_faults.json.
#include "bundle_example.h"
#include "bundle_surgery.h"

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

TEST_CASE("a layered noise is read with its layers") {
  const Bundle bundle = parseBundle(soundFile(), "layered").value();
  CHECK(bundle.noises[0].layers->others == std::vector<std::size_t>{1});
  CHECK(layersOf(bundle, 0) == std::vector<std::size_t>{0, 1});
  CHECK(layersOf(bundle, 1) == std::vector<std::size_t>{1});
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
