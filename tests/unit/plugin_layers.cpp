// SPDX-License-Identifier: MIT
// Layered noises in the engine plugin's plan layer: properties, bindings, blocks and switches.
#include "plugin_plan.h"

#include <lichen/bundle_merge.h>
#include <lichen/layered_noise.h>
#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstring>
#include <string>
#include <utility>

using namespace lichen;
using namespace lichen::test;

TEST_CASE("a layered noise names its layers and index maps, and others only themselves") {
  const OwnedBundle bundle(example::layered());
  auto noise = got<LichenNoiseProperties>(lichenGetNoiseProperties, bundle.handle, 0);
  CHECK(noise.layerCount == 2);
  CHECK(std::array{noise.layers[0], noise.layers[1], noise.layers[2]} ==
        std::array{0u, 1u, LICHEN_NO_NOISE});
  CHECK(std::array{noise.indices[0], noise.indices[1]} == std::array{2u, LICHEN_NO_NOISE});
  REQUIRE(lichenGetNoiseProperties(bundle.handle, 1, &noise) == LICHEN_SUCCESS);
  CHECK(noise.layerCount == 1);
  CHECK(std::array{noise.layers[0], noise.layers[1]} == std::array{1u, LICHEN_NO_NOISE});
}

TEST_CASE("the images of layers and index maps have bindings of their own") {
  const OwnedBundle bundle(example::layered());
  const auto imageAt = [&](std::uint32_t noise, std::uint32_t binding) {
    LichenBinding found;
    LICHEN_INIT(found, LICHEN_STRUCTURE_BINDING);
    CHECK(lichenGetBinding(bundle.handle, noise, binding, &found) == LICHEN_SUCCESS);
    CHECK(found.kind == LICHEN_BINDING_SAMPLED_IMAGE);
    return found.image;
  };
  constexpr std::uint32_t kOcclusion = LICHEN_OCCLUSION_ROUGHNESS_METALLIC;
  constexpr std::uint32_t kSecond = 5; // its slot in the second layer
  const std::uint32_t none = imageAt(0, LICHEN_BINDING_IMAGE(LICHEN_BASE_COLOR));
  CHECK(imageAt(0, LICHEN_BINDING_IMAGE(kOcclusion)) != none);
  CHECK(imageAt(0, LICHEN_BINDING_IMAGE(kSecond)) == imageAt(1, LICHEN_BINDING_IMAGE(kOcclusion)));
  CHECK(imageAt(0, LICHEN_BINDING_TABLE(kSecond)) == imageAt(1, LICHEN_BINDING_TABLE(kOcclusion)));
  CHECK(imageAt(0, LICHEN_BINDING_INDEX(0)) == imageAt(2, LICHEN_BINDING_IMAGE(kOcclusion)));
  CHECK(imageAt(0, LICHEN_BINDING_INDEX(1)) == none);
  CHECK(imageAt(1, LICHEN_BINDING_INDEX(0)) == none);
}

TEST_CASE("a material of a layered noise has a block for each layer and index map") {
  const BundleFile file = example::layered();
  const OwnedBundle bundle(file);
  LichenMaterialParameters parameters = parametersOf(bundle.handle);
  parameters.seed = 5;
  parameters.contrast = 1.5;
  shader::LichenLayeredMaterial block{};
  REQUIRE(lichenFillMaterial(&parameters, nullptr, &block, nullptr) == LICHEN_SUCCESS);
  MaterialNoise material = *file.bundle.materials[0];
  material.seed = 5;
  material.contrast = 1.5;
  const std::array layers{shaderNoise(file.bundle, 0), shaderNoise(file.bundle, 1)};
  const std::array indices{shaderNoise(file.bundle, 2)};
  const shader::LichenLayeredMaterial expected =
      shaderLayeredMaterial(layers, indices, material, {});
  CHECK(std::memcmp(&block, &expected, sizeof block) == 0);
  CHECK(block.first.material.seedWord == latticeSeed(5u, 0));
  CHECK(block.layers[0].material.seedWord == latticeSeed(5u + 0x9E3779B9u, 0));
  CHECK(block.indices[0].material.seedWord == latticeSeed(5u + 4u * 0x9E3779B9u, 0));
  CHECK(block.first.material.contrast == 1.5f);
  CHECK(block.indices[0].material.contrast == 1.0f);
}

TEST_CASE(
    "a layered noise has the mappings that all its noises have, and its switches say layers") {
  const OwnedBundle bundle(example::layered());
  LichenMaterialParameters parameters = parametersOf(bundle.handle);
  LichenShaderSwitches switches;
  LICHEN_INIT(switches, LICHEN_STRUCTURE_SHADER_SWITCHES);
  const LichenMaterialParameters* const all[] = {&parameters};
  REQUIRE(lichenGetShaderSwitches(all, 1, nullptr, &switches, nullptr) == LICHEN_SUCCESS);
  CHECK_THAT(switches.text,
             Catch::StartsWith("-DLICHEN_METHODS=8 -DLICHEN_MAPPINGS=1 -DLICHEN_LAYERS=2 "
                               "-DLICHEN_ROLES=4 "));
  parameters.mapping = LICHEN_MAPPING_SURFACE;
  CHECK(fill(parameters).message == "mapping 2 (surface) does not fit the noise: it has layers");
}

TEST_CASE("layers get no switches with quilting or a surface, and a message that says so") {
  const OwnedBundle layered(example::layered()), quilting(example::smallestQuilting()),
      texton(example::smallestTexton());
  const LichenMaterialParameters first = parametersOf(layered.handle);
  LichenMaterialParameters onSurface = parametersOf(texton.handle);
  onSurface.mapping = LICHEN_MAPPING_SURFACE;
  for (const LichenMaterialParameters& second : {parametersOf(quilting.handle), onSurface}) {
    const LichenMaterialParameters* const all[] = {&first, &second};
    LichenShaderSwitches switches;
    LICHEN_INIT(switches, LICHEN_STRUCTURE_SHADER_SWITCHES);
    LichenDiagnostic diagnostic;
    LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
    CHECK(lichenGetShaderSwitches(all, 2, nullptr, &switches, &diagnostic) == LICHEN_ERROR_USAGE);
    CHECK_THAT(diagnostic.text, Catch::Contains("one has layers") &&
                                    Catch::Contains("ask for the switches of each by itself"));
    CHECK(switches.methods == 0);
    for (const LichenMaterialParameters* const& one : all)
      CHECK(lichenGetShaderSwitches(&one, 1, nullptr, &switches, nullptr) == LICHEN_SUCCESS);
  }
}

TEST_CASE("a grain of the second layer counts for the switches") {
  const auto layerOf = [](Grain grain) {
    Bundle layer = example::smallest().bundle;
    layer.noises[0].as<TilingNoise>().grain = grain;
    layer.noises[0].maps[0].target = MapTarget::occlusionRoughnessMetallic;
    layer.noises[0].maps[0].channels = {MapChannel::occlusion};
    return layer;
  };
  Bundle index = example::smallestKernels().bundle;
  index.noises[0].maps[0].target = MapTarget::occlusionRoughnessMetallic;
  index.noises[0].maps[0].channels = {MapChannel::occlusion};
  const Bundle plain = layerOf(Grain::none);
  const Table& image = plain.tables[plain.noises[0].maps[0].as<TilingMap>().gaussian];
  auto& kernels = index.noises[0].as<MultipleKernelsNoise>();
  kernels.texelsPerTileX = int(image.width); // all tiles have one shape
  kernels.texelsPerTileY = int(image.height);
  for (const Grain grain : {Grain::none, Grain::x}) {
    const Bundle second = layerOf(grain);
    BundleFile file;
    Result<Bundle> layered =
        layerNoises("layered", std::array{BundledNoise{&plain, 0}, BundledNoise{&second, 0}},
                    std::array{BundledNoise{&index, 0}}, {{0, 0.3, 0.2, {false, 1}, {false, 0}}});
    INFO((layered ? "" : layered.error().message));
    REQUIRE(layered);
    file.bundle = std::move(layered).value();
    file.previews.emplace_back();
    file.shape = PreviewShape::none;
    const OwnedBundle bundle(file);
    const LichenMaterialParameters parameters = parametersOf(bundle.handle);
    const LichenMaterialParameters* const all[] = {&parameters};
    LichenShaderSwitches switches;
    LICHEN_INIT(switches, LICHEN_STRUCTURE_SHADER_SWITCHES);
    REQUIRE(lichenGetShaderSwitches(all, 1, nullptr, &switches, nullptr) == LICHEN_SUCCESS);
    CHECK(((switches.features & LICHEN_FEATURE_GRAIN) == 0) == (grain == Grain::none));
  }
}
