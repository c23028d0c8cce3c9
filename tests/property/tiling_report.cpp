// SPDX-License-Identifier: MIT
// What the report on a tiling noise measures of its result and of its exemplar.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/noise_comparison.h>
#include <lichen/noise_report.h>
#include <lichen/suitability.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

using namespace lichen;
using namespace lichen::test;

namespace {

double latticeVisibilityOf(const Bundle& bundle, const MapExemplar& exemplar,
                           std::uint32_t tileRotation) {
  MaterialNoise material;
  material.tileRotation = tileRotation;
  const Result<NoiseComparison> comparison = compareNoise(bundle, material, exemplar);
  REQUIRE(comparison);
  for (const Measure& measure : comparison.value().measures)
    if (measure.name == kLatticeVisibilityName)
      return measure.value.value();
  FAIL("no lattice_visibility");
  return 0.0;
}

std::vector<double> scoresOf(const std::vector<Risk>& risks) {
  std::vector<double> scores;
  for (const Risk& risk : risks)
    scores.push_back(risk.score);
  return scores;
}

} // namespace

TEST_CASE("lattice_visibility follows the lattice of the noise, with any grain") {
  const MapExemplar exemplar = threeMaterials(64, 64, 5);
  Bundle bundle = bundleOf(bakeTiling("a", {&exemplar, 1}, {}));
  // With a wrong mean in all texels, the value depends on the blend weights alone: it is the
  // same at all vertices, and at the centres of all triangles.
  Table& image = bundle.tables[bundle.noises[0].maps[0].as<TilingMap>().gaussian];
  REQUIRE(image.format == TexelFormat::rgba8Unorm);
  for (std::size_t i = 0; i < image.texels.size(); ++i)
    if (i % 4 != 3)
      image.texels[i] = std::byte{160};
  for (const Grain grain : {Grain::none, Grain::x, Grain::y})
    for (const std::uint32_t rotation : {0u, 4u}) {
      bundle.noises[0].as<TilingNoise>().grain = grain;
      INFO("grain " << nameOf(grain) << ", rotation " << rotation);
      CHECK(latticeVisibilityOf(bundle, exemplar, rotation) > 2.5);
    }
}

TEST_CASE("a report shows the original of a straightened exemplar in its own shape") {
  const MapExemplar exemplar = threeMaterials(24, 24, 5);
  Bundle bundle = bundleOf(bakeTiling("a", {&exemplar, 1}, {}));
  bundle.materials = {MaterialNoise{}};
  const std::vector<Risk> risks = assessSuitability(exemplar, true).value();
  const ExemplarOrigin origin{{"straightened"}, threeMaterials(40, 16, 5)};
  const BakeRecord record{.bundle = bundle,
                          .exemplars = {&exemplar, 1},
                          .risks = {&risks, 1},
                          .origins = {&origin, 1},
                          .command = "",
                          .facts = {},
                          .notes = {}};
  const NoiseReport report = encodeNoiseReport(record).value();
  const std::string page(reinterpret_cast<const char*>(report.page.data()), report.page.size());
  const std::string original = page.substr(page.find("alt=\"Original\""));
  CHECK(original.substr(0, original.find("style")).ends_with("width=\"40\" height=\"16\" "));
}

TEST_CASE("all maps have the risk of borders that fade along the grain of the noise") {
  // Neither map has a grain of its own.
  const std::vector<MapExemplar> maps{threeMaterials(64, 64, 5), threeMaterials(64, 64, 6)};
  Noise noise;
  for (const Grain grain : {Grain::none, Grain::y}) {
    noise.data = TilingNoise{grain};
    const auto risks = assessNoise(noise, maps, Periodic::no).value();
    for (std::size_t m = 0; m < maps.size(); ++m) {
      const auto with = [&](Grain assumed) {
        return scoresOf(assessSuitability(maps[m], false, {}, 1.0, assumed).value());
      };
      INFO("map " << m << ", grain " << nameOf(grain));
      CHECK(scoresOf(risks[m]) == with(grain));
      CHECK(scoresOf(risks[m]) != with(grain == Grain::none ? Grain::y : Grain::none));
    }
  }
}
