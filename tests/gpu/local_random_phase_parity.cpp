// SPDX-License-Identifier: MIT
// Local random-phase noise in the shader, through the plugin, against the CPU twin; and the twin
// against an oracle in double precision that sums the cosines of all vertices around a point.
#include "../property/example_exemplar.h"
#include "plane_parity.h"
#include "plugin_host.h"
#include "shared_device.h"

#include <lichen/bundle_writer.h>
#include <lichen/lattice.h>
#include <lichen/local_random_phase.h>
#include <lichen/local_random_phase_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
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

/// A slow evaluation. It takes the windows of all vertices of 7 x 7 cells, and shares only the
/// integer hashes with the code under test.
class Reference {
public:
  explicit Reference(const Bundle& bundle)
      : noise_(bundle.noises[0]), shared_(noise_.as<LocalRandomPhaseNoise>()),
        texels_(cosineTexels(
            decodeLevel(bundle.tables[noise_.maps[0].as<LocalRandomPhaseMap>().cosines], 0),
            CosineImageLayout(shared_))) {}

  /// The Gaussian value at a position in tiles from tile 0, of a point without a footprint.
  [[nodiscard]] std::array<double, 3> at(double x, double y, std::uint32_t seed) const {
    std::array<double, 3> sum{0.5, 0.5, 0.5};
    std::size_t first = 0;
    for (std::size_t octave = 0; octave < shared_.cosines.size(); ++octave) {
      const auto count = std::size_t(shared_.cosines[octave]);
      addOctave(sum, x, y, octave, first, count, seed);
      first += count;
    }
    return sum;
  }

private:
  void addOctave(std::array<double, 3>& sum, double x, double y, std::size_t octave,
                 std::size_t first, std::size_t count, std::uint32_t seed) const {
    const double columns = std::ldexp(shared_.columns / 8.0, int(octave));
    const double rows = std::ldexp(shared_.rows / 8.0, int(octave));
    const auto nearJ = std::int64_t(std::floor(y * rows));
    const auto nearI = std::int64_t(std::floor(x * columns - 0.5 * y * rows));
    const std::uint32_t octaveSeed = pcg(latticeSeed(seed, 0) + std::uint32_t(octave));
    std::array<double, 3> own{};
    double squares = 0.0;
    for (std::int64_t j = nearJ - 3; j <= nearJ + 3; ++j)
      for (std::int64_t i = nearI - 3; i <= nearI + 3; ++i) {
        // The triangles are equilateral on a plane of unit edges.
        const double dx = x - (double(i) + 0.5 * double(j)) / columns, dy = y - double(j) / rows;
        const double edgesX = dx * columns, edgesY = dy * rows * std::sqrt(0.75);
        const double left = 1.0 - (edgesX * edgesX + edgesY * edgesY) / 0.75;
        if (left <= 0.0)
          continue;
        const double window = left * left * left;
        squares += window * window;
        std::uint32_t state = vertexHash(std::uint32_t(i), std::uint32_t(j), octaveSeed);
        const auto share = [](std::uint32_t bits) {
          return double(std::int32_t(bits)) / std::exp2(32.0);
        };
        const std::size_t column = 1 + (state >> 27 & std::uint32_t(shared_.variants - 1));
        for (std::size_t k = first; k < first + count; ++k) {
          state = state * 747796405u + 2891336453u;
          const auto* row = &texels_[k / 2 * (1 + std::size_t(shared_.variants))];
          const CosineTexel &box = row[0][k % 2], &vector = row[column][k % 2];
          const double fx = double(box[0]) + double(box[2]) * share(state << 21);
          const double fy = double(box[1]) + double(box[3]) * share(state << 11);
          const double turns = fx * dx + fy * dy + share(state) + double(vector[3]);
          for (std::size_t c = 0; c < 3; ++c)
            own[c] += window * double(vector[c]) * std::cos(2.0 * std::numbers::pi * turns);
        }
      }
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += own[c] / std::sqrt(squares);
  }

  const Noise& noise_;
  const LocalRandomPhaseNoise& shared_;
  std::vector<std::array<CosineTexel, kRowCosines>> texels_;
};

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

TEST_CASE(
    "local random-phase noise is the sum of the cosines of all vertices under their windows") {
  const BundleFile file = bakedFile({3, GaussianOnly::no, 0.0, 0.0});
  const Bundle bundle = parseBundle(glbOf(file), "noise").value();
  const LocalRandomPhaseEvaluator twin = LocalRandomPhaseEvaluator::create(bundle, 0).value();
  const Reference reference(bundle);
  std::mt19937 generator(3u);
  std::uniform_real_distribution<float> tiles(-9.0f, 9.0f);
  for (const std::int64_t origin : {0, 21, -8}) {
    MaterialNoise material;
    material.seed = 7;
    Placement placement;
    placement.tileOriginX = origin;
    placement.tileOriginY = 2 * origin;
    const shader::LichenMaterial constants = shaderMaterial(bundle, material, placement).material;
    double largest = 0.0;
    for (int k = 0; k < 300; ++k) {
      const TileFootprint at{{tiles(generator), tiles(generator)}, {}, {}};
      const auto value = twin.gaussian(0, constants, at);
      const auto expected = reference.at(double(at.position[0]) + double(origin),
                                         double(at.position[1]) + 2.0 * double(origin), 7);
      for (std::size_t c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(double(value[c]) - expected[c]));
    }
    INFO("origin " << origin);
    // The polynomial of the cosine is within 1.1e-4 of it, and 24 cosines of three vertices have
    // amplitudes of 0.05 on average; the rest are roundings of the position.
    CHECK(largest < 3e-4);
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
