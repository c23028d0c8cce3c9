// SPDX-License-Identifier: MIT
// Quilting on the CPU against the extension's published test vectors, from an independent
// implementation of its specification.
#include "bundle_example.h"
#include "checkout_paths.h"

#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <evaluation/method_evaluator.h>
#include <fstream>

using namespace lichen;

TEST_CASE("values of quilting equal the published test vectors") {
  std::ifstream file(sourcePath("docs/gltf_extension/test_vectors.json"));
  const nlohmann::json vectors = nlohmann::json::parse(file);
  REQUIRE(vectors["quilting"].size() > 20);
  Bundle bundle = example::smallestQuilting().bundle;
  const QuiltingNoise noise = bundle.noises[0].as<QuiltingNoise>();
  for (const nlohmann::json& v : vectors["quilting"]) {
    INFO(v.dump());
    bundle.noises[0].as<QuiltingNoise>().offsets =
        v["hasOffsets"].get<bool>() ? noise.offsets : std::vector<std::array<double, 2>>();
    const auto evaluator = methodEvaluator(bundle, 0);
    MaterialNoise use;
    use.seed = v["seed"];
    use.contrast = v["contrast"];
    Placement placement;
    placement.periodTilesX = v["periodTiles"][0];
    placement.periodTilesY = v["periodTiles"][1];
    placement.periodic = placement.periodTilesX > 0.0;
    const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, use, placement);
    TileFootprint at;
    at.position = v["position"].get<std::array<float, 2>>();
    at.dx = v["dpdx"].get<std::array<float, 2>>();
    at.dy = v["dpdy"].get<std::array<float, 2>>();
    constexpr double kRounding = 2e-4; // of floats in powers of up to 24, and of half floats
    const auto height = evaluator->evaluate(0, material, at);
    CHECK(double(height[0]) == Approx(v["height"][0].get<double>()).margin(kRounding));
    const auto normal = evaluator->evaluate(1, material, at);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(double(normal[c]) == Approx(v["normal"][c].get<double>()).margin(kRounding));
  }
}
