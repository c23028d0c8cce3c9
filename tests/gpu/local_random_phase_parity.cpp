// SPDX-License-Identifier: MIT
// Local random-phase noise in the shader, through the plugin, against the CPU twin.
#include "../property/example_exemplar.h"
#include "plane_parity.h"
#include "plugin_host.h"
#include "shared_device.h"

#include <lichen/bundle_writer.h>
#include <lichen/local_random_phase.h>
#include <lichen/local_random_phase_evaluate.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr const char* kPass = "local_random_phase_evaluate.comp";
/// The numbering of local_random_phase_evaluate.comp.
enum Quantity { kValue, kGaussian, kGradient };

struct Kind {
  std::size_t channels;
  GaussianOnly gaussian;
  double structure, guide;
};

/// Of 16 bits, as rounding of tables has a test of its own for all methods.
BundleFile bakedFile(const Kind& kind) {
  const MapExemplar map = ofChannels(kind.channels);
  LocalRandomPhaseOptions options;
  options.bits = 16;
  options.cosines = 24;
  options.gaussian = kind.gaussian;
  options.structure = kind.structure;
  options.guide = kind.guide;
  options.turbulence = kind.structure < 1.0 ? 0.05 : 0.0;
  Result<LocalRandomPhaseBake> bake = bakeLocalRandomPhase("noise", {&map, 1}, options);
  REQUIRE(bake);
  BundleFile file;
  file.bundle.tables = std::move(bake.value().tables);
  file.bundle.noises = {std::move(bake.value().noise)};
  file.bundle.materials = {MaterialNoise()};
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  return file;
}

} // namespace

TEST_CASE("the local random-phase shader matches its CPU twin: 99.9 % within 1/1024, all within "
          "1/255") {
  for (const Kind& kind :
       {Kind{3, GaussianOnly::no, 0.0, 0.0}, Kind{3, GaussianOnly::yes, 0.0, 0.0},
        Kind{1, GaussianOnly::no, 0.0, 0.0}, Kind{3, GaussianOnly::no, 0.6, 0.0},
        Kind{3, GaussianOnly::no, 1.0, 1.0}, Kind{1, GaussianOnly::no, 0.5, 1.0}}) {
    const BundleFile file = bakedFile(kind);
    const bool hasList = file.bundle.noises[0].as<LocalRandomPhaseNoise>().structure.offsets > 0;
    REQUIRE(hasList == (kind.guide > 0.0));
    VulkanDevice* const device = sharedDevice();
    const std::vector<std::byte> glb = glbOf(file);
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(sharedContext(), glb);
    const LocalRandomPhaseEvaluator twin = LocalRandomPhaseEvaluator::create(bundle, 0).value();
    INFO("channels " << kind.channels << ", structure " << kind.structure << ", guide "
                     << kind.guide);
    checkPlaneParity(host, twin, committedShader(kPass), samplePoints(1000));
    CHECK(device->messages().texts() == std::vector<std::string>{});
  }
}

TEST_CASE("the gradient of a height in the shader matches its CPU twin") {
  for (const double structure : {0.0, 0.6}) {
    const std::vector<std::byte> glb = glbOf(bakedFile({1, GaussianOnly::no, structure, 0.0}));
    const Bundle bundle = parseBundle(glb, "noise").value();
    PluginHost host(sharedContext(), glb);
    const LocalRandomPhaseEvaluator twin = LocalRandomPhaseEvaluator::create(bundle, 0).value();
    const std::vector<Point> points = samplePoints(500);
    for (const MaterialUse& use : manyUses(host.use())) {
      const auto found = host.evaluate(committedShader(kPass), kGradient, use, points);
      double squares = 0.0, errors = 0.0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto expected =
            twin.gradient(0, host.material(), footprintOf(points[k], host.material()));
        for (std::size_t c = 0; c < 3; ++c) {
          squares += c > 0 ? std::pow(double(expected[c]), 2.0) : 0.0;
          errors += c > 0 ? std::pow(double(found[k][c]) - double(expected[c]), 2.0) : 0.0;
        }
        CHECK(std::abs(found[k][0] - expected[0]) < 1.0f / 255.0f);
      }
      INFO("structure " << structure);
      CHECK(std::sqrt(errors / squares) < 0.01); // differences of structures round
    }
  }
}

TEST_CASE("local random-phase noise repeats after its period and nowhere jumps") {
  const double structure = GENERATE(0.0, 0.7);
  const BundleFile file = bakedFile({3, GaussianOnly::no, structure, structure});
  const Bundle bundle = parseBundle(glbOf(file), "noise").value();
  const LocalRandomPhaseEvaluator twin = LocalRandomPhaseEvaluator::create(bundle, 0).value();
  std::mt19937 generator(5u);
  for (const std::array<double, 2>& period :
       {std::array{1.0, 1.0}, std::array{2.0, 3.0}, std::array{1.375, 0.75}}) {
    Placement placement;
    placement.periodic = true;
    placement.periodTilesX = period[0];
    placement.periodTilesY = period[1];
    const shader::LichenMaterial constants =
        shaderMaterial(bundle, MaterialNoise(), placement).material;
    std::uniform_real_distribution<float> inX(0.0f, float(period[0])), inY(0.0f, float(period[1]));
    const auto at = [&](float x, float y) {
      return twin.gaussian(0, constants, TileFootprint{{x, y}, {}, {}});
    };
    for (int k = 0; k < 200; ++k) {
      const float x = inX(generator), y = inY(generator);
      const auto value = at(x, y);
      for (const auto& other : {at(x + float(period[0]), y), at(x, y + float(period[1])),
                                at(x - float(period[0]), y - 2.0f * float(period[1]))})
        for (std::size_t c = 0; c < 3; ++c)
          CHECK(std::abs(value[c] - other[c]) < 2e-3f); // the position's rounding
      // From both sides of a border of the period.
      const auto before = at(1e-5f, y), after = at(-1e-5f, y);
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(std::abs(before[c] - after[c]) < 4e-3f); // the steepest slope seen, times the step
    }
  }
}
