// SPDX-License-Identifier: MIT
// Quilting in the shader, through the plugin, against the CPU twin.
#include "plane_parity.h"
#include "shared_device.h"

#include <lichen/quilting.h>
#include <lichen/quilting_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr const char* kPass = "quilting_evaluate.comp";
constexpr float kCellsX = kWidth / 2, kCellsY = kHeight / 2; // texels of the image of cells

/// With the offsets of a list and a grain or without both, as the guide says. Of 16 bits, as
/// rounding of images has a test of its own.
std::vector<std::byte> bakedGlb(std::size_t channels, double guide) {
  const MapExemplar map = ofChannels(channels);
  QuiltingOptions options;
  options.bits = 16;
  options.guide = guide;
  Result<QuiltingBake> bake = bakeQuilting("noise", {&map, 1}, options);
  REQUIRE(bake);
  bake.value().noise.as<QuiltingNoise>().grain = guide > 0.0 ? Grain::x : Grain::none;
  BundleFile file;
  file.bundle.tables = std::move(bake.value().tables);
  file.bundle.noises = {std::move(bake.value().noise)};
  file.bundle.materials = {MaterialNoise()};
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  return glbOf(file);
}

/// By how much the twin's value varies around the point, as far as a sampler with 8 bits below the
/// texel rounds the position of a fetch of cells: a cut between two of them is a texel wide, and
/// the weights there have a slope of 16. Each of the three fetches is rounded by itself.
std::array<float, 4> variation(const QuiltingEvaluator& twin,
                               const shader::LichenMaterial& material, const TileFootprint& at) {
  constexpr float kRounding = 1.0f / 512.0f, kFetches = 3.0f;
  const std::array<float, 4> here = twin.evaluate(0, material, at);
  std::array<float, 4> most{};
  for (const float x : {-1.0f, 0.0f, 1.0f})
    for (const float y : {-1.0f, 0.0f, 1.0f}) {
      TileFootprint beside = at;
      beside.position[0] += x * kRounding / kCellsX;
      beside.position[1] += y * kRounding / kCellsY;
      const std::array<float, 4> there = twin.evaluate(0, material, beside);
      for (std::size_t c = 0; c < 4; ++c)
        most[c] = std::max(most[c], kFetches * std::abs(there[c] - here[c]));
    }
  return most;
}

} // namespace

TEST_CASE("but for rounded fetches of cells the quilting shader matches its CPU twin") {
  for (const std::size_t channels : {std::size_t(1), std::size_t(3)})
    for (const double guide : {0.0, 1.0}) {
      INFO("channels " << channels << ", guide " << guide);
      const std::vector<std::byte> glb = bakedGlb(channels, guide);
      const Bundle bundle = parseBundle(glb, "noise").value();
      REQUIRE(bundle.noises[0].as<QuiltingNoise>().offsets.empty() == (guide == 0.0));
      PluginHost host(sharedContext(), glb);
      const QuiltingEvaluator twin = QuiltingEvaluator::create(bundle, 0).value();
      const std::vector<Point> points = samplePoints(600);
      for (const MaterialUse& use : manyUses(host.use())) {
        const auto values = host.evaluate(committedShader(kPass), 0, use, points);
        ParityErrors errors;
        for (std::size_t k = 0; k < points.size(); ++k) {
          const TileFootprint at = footprintOf(points[k], host.material());
          const std::array<float, 4> expected = twin.evaluate(0, host.material(), at);
          const std::array<float, 4> allowed = variation(twin, host.material(), at);
          for (std::size_t c = 0; c < 4; ++c)
            errors.add(std::max(0.0f, std::abs(values[k][c] - expected[c]) - allowed[c]));
        }
        errors.check();
      }
      CHECK(sharedDevice()->messages().texts() == std::vector<std::string>{});
    }
}
