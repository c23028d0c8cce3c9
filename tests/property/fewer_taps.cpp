// SPDX-License-Identifier: MIT
// Tiling with fewer taps than three: the number of taps, preserved mean, variance and histogram,
// continuity except at the centres of triangles, and preserved colour in distant views.
#include "example_exemplar.h"
#include "filtered_views.h"

#include <lichen/lattice.h>
#include <lichen/tiling.h>
#include <lichen/tiling_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <tiling/fewer_taps.h>
#include <vector>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::tiling;

namespace {

constexpr int kTexels = 128; // texels per side of the exemplar

const Bundle& exampleBundle() {
  static const Bundle bundle = [] {
    const MapExemplar map = threeMaterials(kTexels, kTexels, 11);
    TilingOptions options;
    options.bits = 16;
    Result<TilingBake> bake = bakeTiling("example", {&map, 1}, options);
    REQUIRE(bake);
    Bundle baked;
    baked.tables = std::move(bake.value().tables);
    baked.noises = {std::move(bake.value().noise)};
    return baked;
  }();
  return bundle;
}

shader::LichenMaterial parameters() {
  return shaderMaterial(exampleBundle(), MaterialNoise{}, {}).material;
}

/// The point (f, g) in the cell (i, j) of the lattice, with a square pixel of this side [tiles].
TileFootprint placeIn(double i, double j, double f, double g, double side = 0.0) {
  TileFootprint at;
  at.position = {float((i + f + 0.5 * (j + g)) / kLatticeColumnsPerTile),
                 float((j + g) / kLatticeRowsPerTile)};
  at.dx = {float(side), 0.0f};
  at.dy = {0.0f, float(side)};
  return at;
}

Taps tapsOf(const TileFootprint& at, const TilingQuality& quality) {
  Taps taps = tapsAt(parameters(), shaderNoise(exampleBundle(), 0), at.position);
  reduceTaps(taps, at, quality);
  return taps;
}

int takenOf(const Taps& taps) {
  return int(std::count_if(taps.weight.begin(), taps.weight.end(),
                           [](float weight) { return weight > 0.0f; }));
}

/// The side of a pixel at this share of the transition to one tap, in units of the quality's limit.
constexpr double sideOf(double share) { return 0.5 * (1.0 + share); }

/// Greatest difference between the distribution functions of two sorted samples.
double kolmogorovSmirnov(std::vector<double> a, std::vector<double> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  double largest = 0.0;
  for (const double value : a) {
    const auto below = [&](const std::vector<double>& sample) {
      return double(std::upper_bound(sample.begin(), sample.end(), value) - sample.begin()) /
             double(sample.size());
    };
    largest = std::max(largest, std::abs(below(a) - below(b)));
  }
  return largest;
}

struct Moments {
  double mean = 0.0, variance = 0.0;
};

Moments momentsOf(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double value : values)
    sum += value, squares += value * value;
  const double count = double(values.size()), mean = sum / count;
  return {mean, squares / count - mean * mean};
}

} // namespace

TEST_CASE("two taps use the two greatest weights minus the third, and sum to 1") {
  for (std::uint32_t k = 0; k < 20000; ++k) {
    const auto random = pcg3d({k, 3u, 4u});
    const TileFootprint at =
        placeIn(double(random[2] % 16u), 2.0, random[0] * 0x1p-32, random[1] * 0x1p-32);
    Taps three = tapsAt(parameters(), shaderNoise(exampleBundle(), 0), at.position);
    const Taps two = tapsOf(at, {2, 0.0});
    // The order of taps differs; the tile identifies each tap.
    const auto of = [&](const std::array<float, 2>& position) {
      const auto found = std::find(three.position.begin(), three.position.end(), position);
      REQUIRE(found != three.position.end());
      return double(three.weight[std::size_t(found - three.position.begin())]);
    };
    const double least = *std::min_element(three.weight.begin(), three.weight.end());
    REQUIRE(two.weight[2] == 0.0f);
    REQUIRE(two.weight[0] + two.weight[1] == Approx(1.0f).epsilon(1e-6));
    REQUIRE(two.norm == Approx(std::hypot(two.weight[0], two.weight[1])).epsilon(1e-6));
    // The remainder of a sum of 1; floats leave an error of 1e-7 each.
    const double left = 1.0 - 3.0 * least;
    for (std::size_t t = 0; t < 2; ++t)
      REQUIRE(two.weight[t] == Approx((of(two.position[t]) - least) / left).margin(1e-6 / left));
  }
}

TEST_CASE("on the edges of triangles two taps have the weights that three have") {
  for (int k = 1; k < 20; ++k)
    for (const auto& [f, g] :
         {std::pair{k / 20.0, 0.0}, {0.0, k / 20.0}, {k / 20.0, 1 - k / 20.0}}) {
      const TileFootprint at = placeIn(3.0, -2.0, f, g);
      Taps three = tapsAt(parameters(), shaderNoise(exampleBundle(), 0), at.position);
      std::sort(three.weight.begin(), three.weight.end(), std::greater<>());
      const Taps two = tapsOf(at, {2, 0.0});
      for (std::size_t t = 0; t < 3; ++t)
        CHECK(two.weight[t] == Approx(three.weight[t]).margin(1e-5));
    }
}

TEST_CASE("pixels at the limit take one tap, pixels at half of it take all, and the weights change "
          "continuously between") {
  constexpr double kLimit = 0.25;
  for (const int most : {3, 2})
    for (std::uint32_t k = 0; k < 300; ++k) {
      const auto random = pcg3d({k, 5u, 6u});
      const auto at = [&](double share) {
        return placeIn(double(random[2] % 16u), 1.0, random[0] * 0x1p-32, random[1] * 0x1p-32,
                       kLimit * sideOf(share));
      };
      REQUIRE(takenOf(tapsOf(at(0.0), {most, kLimit})) == most);
      REQUIRE(takenOf(tapsOf(at(1.0), {most, kLimit})) == 1);
      REQUIRE(takenOf(tapsOf(at(5.0), {most, kLimit})) == 1);
      const Taps all = tapsAt(parameters(), shaderNoise(exampleBundle(), 0), at(0.0).position);
      const double greatest = *std::max_element(all.weight.begin(), all.weight.end());
      double before = double(tapsOf(at(0.0), {most, kLimit}).weight[0]);
      constexpr int kSteps = 200;
      for (int step = 1; step <= kSteps; ++step) {
        const Taps taps = tapsOf(at(double(step) / kSteps), {most, kLimit});
        REQUIRE(taps.weight[0] + taps.weight[1] + taps.weight[2] == Approx(1.0f).epsilon(1e-6));
        REQUIRE(double(taps.weight[0]) >= before - 1e-5);
        before = double(taps.weight[0]);
        REQUIRE(before >= greatest - 1e-5); // and the tile of the greatest weight keeps that rank
      }
    }
}

TEST_CASE("the size of an anisotropic pixel is its area, with the anisotropy clamped to 16") {
  const auto taken = [](double width, double height) {
    TileFootprint at = placeIn(0.0, 0.0, 0.4, 0.25);
    at.dx = {float(width), 0.0f};
    at.dy = {0.0f, float(height)};
    return takenOf(tapsOf(at, {3, 0.25}));
  };
  CHECK(taken(0.5, 0.125) == 1); // an area of 1/4 x 1/4
  CHECK(taken(0.5, 0.12) == 2);  // a little less: the tap of least weight is the first to go
  CHECK(taken(1.0, 0.0) == 1);   // like 1 x 1/16
  CHECK(taken(0.49, 0.0) == 3);  // like 0.49 x 0.03, less than half of the limit's side
  CHECK(taken(0.125, 0.125) == 3);
}

TEST_CASE("mean, variance and histogram are the same everywhere in a triangle", "[large]") {
  // One pixel per texel, at texel centres, where a fetch loses nothing. The limit of one tap is set
  // so that such pixels are in the transition to it.
  constexpr double kPixel = 1.0 / kTexels;
  const auto samples = [](double f, double g, const TilingQuality& quality) {
    const Result<TilingEvaluator> evaluator = TilingEvaluator::create(exampleBundle(), 0, quality);
    REQUIRE(evaluator);
    constexpr int kSide = 90;
    std::vector<double> values;
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        TileFootprint at = placeIn(i, j, f, g, kPixel);
        for (float& coordinate : at.position)
          coordinate = (std::floor(coordinate * kTexels) + 0.5f) / kTexels;
        values.push_back(double(evaluator.value().evaluate(0, parameters(), at)[0]));
      }
    return values;
  };
  const std::vector<double> vertex = samples(0.001, 0.001, {});
  const Moments wanted = momentsOf(vertex);
  for (const TilingQuality& quality :
       {TilingQuality{2, 0.0}, TilingQuality{3, kPixel / sideOf(0.5)},
        TilingQuality{2, kPixel / sideOf(0.5)}, TilingQuality{2, kPixel}})
    for (const auto& [f, g] :
         {std::pair{1.0 / 3.0, 1.0 / 3.0}, {0.4, 0.3}, {0.5, 0.25}, {0.7, 0.5}}) {
      const std::vector<double> found = samples(f, g, quality);
      const Moments moments = momentsOf(found);
      INFO(quality.taps << " taps, one from " << quality.oneTapTiles << " tiles, at " << f << ", "
                        << g);
      // 8100 cells: the standard error of the difference of two means is 1.6 % of a standard
      // deviation, and that of two variances at most 2.2 %. The limits are 4.5 of these for 16
      // positions: alpha 1e-4 in all.
      CHECK(std::abs(moments.mean - wanted.mean) < 0.07 * std::sqrt(wanted.variance));
      CHECK(moments.variance == Approx(wanted.variance).epsilon(0.10));
      // False alarms of 1e-6: sqrt(ln(2e6) / 2) sqrt(2 / 8100).
      CHECK(kolmogorovSmirnov(found, vertex) < 0.0423);
    }
}

TEST_CASE("tile borders reduce correlations by the documented amount") {
  // Over a distance, the exemplar's correlation is multiplied by the mean of the sum of w w' / (W
  // W') over the tiles that two positions share. docs/decisions/023-fewer-taps.md lists it for 1/32
  // and 1/8 of a tile, computed by another program. 40000 pairs, whose products have a standard
  // deviation of at most 0.45: 4.4 standard errors of 0.0023, alpha 1e-5 each.
  struct Kept {
    TilingQuality quality;
    double side, near, far;
  };
  const auto kept = [](const TilingQuality& quality, double side, double distance) {
    constexpr std::uint32_t kPairs = 40000;
    constexpr float kSameTile = 0.5f / kTexels; // offsets differ by a texel or more
    double sum = 0.0;
    for (std::uint32_t k = 0; k < kPairs; ++k) {
      const auto random = pcg3d({k, 7u, 8u});
      TileFootprint here = placeIn(double(random[2] % 64u), double(random[2] >> 6u & 63u),
                                   random[0] * 0x1p-32, random[1] * 0x1p-32, side);
      TileFootprint there = here;
      const double turn = 2.0 * std::numbers::pi * double(pcg(k)) * 0x1p-32;
      there.position[0] += float(distance * std::cos(turn));
      there.position[1] += float(distance * std::sin(turn));
      const Taps a = tapsOf(here, quality), b = tapsOf(there, quality);
      const auto offset = [](const Taps& taps, std::size_t t, const TileFootprint& at) {
        return std::array{taps.position[t][0] - at.position[0],
                          taps.position[t][1] - at.position[1]};
      };
      for (std::size_t s = 0; s < 3; ++s)
        for (std::size_t t = 0; t < 3; ++t) {
          const auto first = offset(a, s, here), second = offset(b, t, there);
          if (std::abs(first[0] - second[0]) < kSameTile &&
              std::abs(first[1] - second[1]) < kSameTile)
            sum += double(a.weight[s]) * double(b.weight[t]) / double(a.norm * b.norm);
        }
    }
    return sum / kPairs;
  };
  for (const auto& [quality, side, near, far] :
       {Kept{{3, 0.0}, 0.0, 0.979, 0.734}, Kept{{2, 0.0}, 0.0, 0.947, 0.635},
        Kept{{3, 0.25}, 0.25, 0.865, 0.490}}) {
    INFO(quality.taps << " taps, one from " << quality.oneTapTiles << " tiles");
    CHECK(kept(quality, side, 1.0 / 32) == Approx(near).margin(0.01));
    CHECK(kept(quality, side, 1.0 / 8) == Approx(far).margin(0.01));
  }
}

TEST_CASE("at the centre of a triangle one tap with weight 1 remains") {
  // All weights are equal at this point, where the borders of three tiles meet. Floats may or may
  // not hit it exactly: the test checks both cases.
  Taps taps;
  taps.weight = {1.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f};
  for (const TilingQuality& quality : {TilingQuality{2, 0.0}, TilingQuality{3, 0.25}}) {
    Taps middle = taps;
    reduceTaps(middle, placeIn(0.0, 0.0, 0.0, 0.0, 1.0), quality);
    CHECK(middle.weight == std::array{1.0f, 0.0f, 0.0f});
    CHECK(middle.norm == 1.0f);
  }
  const Result<TilingEvaluator> evaluator = TilingEvaluator::create(exampleBundle(), 0, {2, 0.0});
  REQUIRE(evaluator);
  for (int k = 0; k < 1000; ++k) {
    TileFootprint at = placeIn(k, 0.0, 1.0 / 3.0, 1.0 / 3.0);
    at.position[0] += float(k % 7 - 3) * std::numeric_limits<float>::epsilon();
    const auto value = evaluator.value().evaluate(0, parameters(), at);
    for (std::size_t c = 0; c < 3; ++c)
      REQUIRE((value[c] >= 0.0f && value[c] <= 1.0f));
  }
}

TEST_CASE("values change continuously with the size of a pixel, and with its position except at "
          "triangle centres") {
  // The largest step of a value. A jump keeps its height at any step size; a continuous change is
  // proportional to the step size.
  const auto largestStep = [](const Plane& plane, const auto& footprintAt, int steps) {
    double largest = 0.0;
    Light before = plane(footprintAt(0));
    for (int k = 1; k <= steps; ++k) {
      const Light now = plane(footprintAt(k));
      for (std::size_t c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(now[c] - before[c]));
      before = now;
    }
    return largest;
  };
  for (const TilingQuality& quality : {TilingQuality{2, 0.0}, TilingQuality{3, 0.25},
                                       TilingQuality{2, 0.25}, TilingQuality{2, 0.03}}) {
    const Plane plane = noisePlane(exampleBundle(), Mapping::uv, {}, quality);
    INFO(quality.taps << " taps, one from " << quality.oneTapTiles << " tiles");
    const auto growing = [&](double octaves, int steps) {
      return largestStep(
          plane,
          [&](int k) {
            const auto side = float(std::exp2(octaves * k) / (8.0 * kTexels));
            return TileFootprint{{0.37f, 0.61f}, {side, 0.0f}, {0.0f, 1.5f * side}};
          },
          steps);
    };
    constexpr int kOctaves = 18; // an eighth of a texel to 256 tiles
    CHECK(growing(1.0 / 512, 512 * kOctaves) < 0.3 * growing(1.0 / 64, 64 * kOctaves));
    // A line 4 texels from the nearest centres, over 3.5 triangles, in pixels that are a third into
    // the transition to one tap of the last quality.
    const auto across = [&](double stepTexels) {
      return largestStep(
          plane,
          [&](int k) {
            const auto side = float(0.02);
            return TileFootprint{
                {float(stepTexels * k / kTexels), 0.3f}, {side, 0.0f}, {0.0f, side}};
          },
          int(kTexels / stepTexels));
    };
    CHECK(across(1.0 / 512) < 0.3 * across(1.0 / 64));
  }
}

TEST_CASE("views with fewer taps have the same mean colour and contrast at all distances",
          "[large]") {
  constexpr int kPixels = 1200;
  for (const TilingQuality& quality : {TilingQuality{2, 0.0}, TilingQuality{2, 0.25}}) {
    const Plane plane = noisePlane(exampleBundle(), Mapping::uv, {}, quality);
    for (const double texels : {0.5, 2.0, 4.0, 16.0, 32.0, 128.0}) {
      const FilteredView view = filteredView(plane, texels / kTexels, texels / kTexels, kPixels, 6);
      INFO(quality.taps << " taps, one from " << quality.oneTapTiles << " tiles, " << texels
                        << " texels: contrast " << view.contrast() << ", difference "
                        << view.difference());
      CHECK(view.meanError < view.meanTolerance(0.3, kPixels));
      if (texels <= 4.0) // beyond that, this exemplar has little contrast left
        CHECK(std::abs(view.contrast() - 1.0) < 0.12);
      else
        CHECK(view.filteredVariance < 1.5 * std::max(0.0, view.sampledVariance) + 3e-4);
    }
  }
}

TEST_CASE("the error for an invalid quality has its number") {
  const auto messageOf = [](const TilingQuality& quality) {
    const Result<TilingEvaluator> created = TilingEvaluator::create(exampleBundle(), 0, quality);
    REQUIRE_FALSE(created);
    CHECK(created.error().kind == ErrorKind::usage);
    return created.error().message;
  };
  CHECK(messageOf({1, 0.0}) == "taps 1; expected 2 or 3");
  CHECK(messageOf({4, 0.0}) == "taps 4; expected 2 or 3");
  CHECK(messageOf({3, -1.0}).starts_with("one tap from -1.0"));
  CHECK(messageOf({3, 2e6}).starts_with("one tap from 2000000.0"));
  CHECK(messageOf({3, std::numeric_limits<double>::quiet_NaN()}).starts_with("one tap from nan"));
}
