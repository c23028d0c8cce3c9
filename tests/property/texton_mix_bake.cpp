// SPDX-License-Identifier: MIT
// Baked mixes: the statistics of their steps, sets of maps, views along the mix, and errors.
#include "example_exemplar.h"
#include "synthetic_texton.h"

#include <lichen/texton_mix.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <exemplar/color_space.h>
#include <exemplar/value_encoding.h>

using namespace lichen;
using namespace lichen::test;
using Eigen::MatrixXd;

namespace {

MixedExemplar exemplarOf(const std::string& name, std::uint64_t seed, int blurRadius = 3,
                         int side = 48) {
  return {name, {threeMaterials(side, side, seed, blurRadius)}};
}

TextonMixOptions smallOptions(int steps) {
  TextonMixOptions options;
  options.texton.support = 12;
  options.steps = steps;
  return options;
}

TextonMixBake bakeOf(std::span<const MixedExemplar> exemplars, const TextonMixOptions& options) {
  Result<TextonMixBake> bake = bakeTextonMix("mix", exemplars, options);
  INFO((bake ? "" : bake.error().message));
  REQUIRE(bake);
  return std::move(bake).value();
}

MatrixXd matrixOf(const std::vector<double>& values) {
  const auto n = Eigen::Index(std::lround(std::sqrt(double(values.size()))));
  return Eigen::Map<const MatrixXd>(values.data(), n, n);
}

/// Mean and covariance of a map's own pixels, as a noise stores them: roots of light for colours.
exemplar::Moments momentsOf(const MapExemplar& map) {
  return exemplar::momentsOf(exemplar::asStored(map).values, int(map.channels.size()));
}

void checkStatistics(const std::vector<double>& mean, const std::vector<double>& covariance,
                     const MapExemplar& map) {
  const exemplar::Moments expected = momentsOf(map);
  for (Eigen::Index c = 0; c < expected.mean.size(); ++c)
    CHECK(mean[std::size_t(c)] == Approx(expected.mean[c]).epsilon(1e-9));
  const MatrixXd difference = matrixOf(covariance) - expected.covariance;
  for (Eigen::Index c = 0; c < expected.mean.size(); ++c)
    for (Eigen::Index d = 0; d < expected.mean.size(); ++d)
      CHECK(std::abs(difference(c, d)) <=
            1e-4 * std::sqrt(expected.covariance(c, c) * expected.covariance(d, d)));
}

/// The noise of a bake, its evaluator and its parameters.
struct Evaluation {
  Evaluation(Noise noise, std::vector<Table> tables, std::uint32_t seed = 1)
      : bundle{std::move(tables), {std::move(noise)}, {}, {}, {}},
        evaluator(methodEvaluator(bundle, 0)) {
    MaterialNoise materialNoise;
    materialNoise.seed = seed;
    material = shaderMaterial(bundle, materialNoise, {});
    constants = shaderNoise(bundle, 0);
  }

  Bundle bundle;
  std::shared_ptr<const MethodEvaluator> evaluator;
  shader::LichenTriplanarMaterial material{};
  shader::LichenNoise constants{};
};

} // namespace

TEST_CASE("the ends of a mix have the statistics of their exemplars, and means between them are "
          "interpolated") {
  const std::vector<MixedExemplar> exemplars{exemplarOf("a", 7), exemplarOf("b", 8, 1),
                                             exemplarOf("c", 9)};
  const TextonMixBake bake = bakeOf(exemplars, smallOptions(5));
  CHECK(bake.noise.as<TextonShape>().steps == 9);
  CHECK(bake.quality.modelErrors.size() == 9);
  CHECK(bake.quality.largestStep > 0.0);
  const NoiseMap& map = bake.noise.maps.at(0);
  REQUIRE(map.as<TextonMap>().laterSteps.size() == 8);
  checkStatistics(map.mean, map.covariance, exemplars[0].maps[0]);
  checkStatistics(map.as<TextonMap>().laterSteps[3].mean,
                  map.as<TextonMap>().laterSteps[3].covariance, exemplars[1].maps[0]);
  checkStatistics(map.as<TextonMap>().laterSteps[7].mean,
                  map.as<TextonMap>().laterSteps[7].covariance, exemplars[2].maps[0]);
  std::vector<double> greatest(3, 0.0);
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(map.as<TextonMap>().laterSteps[0].mean[c] ==
          Approx(0.75 * map.mean[c] + 0.25 * map.as<TextonMap>().laterSteps[3].mean[c]));
    CHECK(map.as<TextonMap>().laterSteps[5].mean[c] ==
          Approx(0.5 * map.as<TextonMap>().laterSteps[3].mean[c] +
                 0.5 * map.as<TextonMap>().laterSteps[7].mean[c]));
    greatest[c] = map.covariance[4 * c];
    for (const TextonStep& step : map.as<TextonMap>().laterSteps)
      greatest[c] = std::max(greatest[c], step.covariance[4 * c]);
    CHECK(map.as<TextonMap>().scale[c] == Approx(6.0 * std::sqrt(greatest[c])));
  }
}

TEST_CASE("weights give one texton with the exemplars' weighted mean") {
  const std::vector<MixedExemplar> exemplars{exemplarOf("a", 7), exemplarOf("b", 8, 1),
                                             exemplarOf("c", 9)};
  TextonMixOptions options = smallOptions(21);
  options.weights = {2.0, 1.0, 1.0};
  const TextonMixBake bake = bakeOf(exemplars, options);
  CHECK(bake.noise.as<TextonShape>().steps == 1);
  CHECK(bake.noise.maps[0].as<TextonMap>().laterSteps.empty());
  for (Eigen::Index c = 0; c < 3; ++c) {
    double mean = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      mean += (k == 0 ? 0.5 : 0.25) * momentsOf(exemplars[k].maps[0]).mean[c];
    CHECK(bake.noise.maps[0].mean[std::size_t(c)] == Approx(mean));
  }
  options.weights = {0.0, 1.0, 0.0};
  const TextonMixBake alone = bakeOf(exemplars, options);
  checkStatistics(alone.noise.maps[0].mean, alone.noise.maps[0].covariance, exemplars[1].maps[0]);
}

TEST_CASE("the variance of filtered noise at each step of a mix follows its losses, also beyond "
          "the last mip") {
  // Steps with 1, 1.5 and 2 times the first standard deviation, of unrelated white coefficients.
  BundleFile file = syntheticTextonBundle(
      {.coefficientsX = 12, .coefficientsY = 10, .mipLevels = 2, .steps = 3, .channels = 1});
  const Evaluation noise(file.bundle.noises[0], file.bundle.tables);
  const NoiseMap& map = noise.bundle.noises[0].maps[0];
  constexpr int kSide = 64; // positions, 40 x 40 texels each: further apart than textons reach
  for (int step = 0; step < 3; ++step)
    for (const double level : {0.0, 1.0, 2.0}) {
      // Textons are fetched half a level below the footprint's (docs/decisions/003).
      const float side = float(level > 0.0 ? std::exp2(level + 0.5) : 1.0);
      double sum = 0.0, squares = 0.0, lost = 0.0;
      for (int k = 0; k < kSide * kSide; ++k) {
        TileFootprint at;
        at.position = {(float(k % kSide) * 40.0f + 0.5f) / noise.constants.tileTexelsX,
                       (float(k / kSide) * 40.0f + 0.5f) / noise.constants.tileTexelsY};
        at.dx = {side / noise.constants.tileTexelsX, 0.0f};
        at.dy = {0.0f, side / noise.constants.tileTexelsY};
        const MethodEvaluator::Gaussian gaussian =
            noise.evaluator->gaussian(0, noise.material, at, {float(step) / 2.0f, {}});
        sum += double(gaussian.value[0]) - 0.5;
        squares += std::pow(double(gaussian.value[0]) - 0.5, 2);
        lost = double(gaussian.lost[0]);
      }
      INFO("step " << step << ", level " << level);
      const double count = kSide * kSide;
      const std::vector<double>& losses =
          step == 0 ? map.as<TextonMap>().mipLoss
                    : map.as<TextonMap>().laterSteps[std::size_t(step) - 1].mipLoss;
      // Kept amplitudes are stored as bytes.
      CHECK(lost == Approx(losses[std::size_t(level)]).margin(2.0 / 255.0));
      // In units of the step's own variance. The variance of 4,096 independent values with a
      // kurtosis of up to 4 has a relative standard error of sqrt(3 / 4096). The limit is five of
      // these.
      CHECK(36.0 * squares / count == Approx(1.0 - lost).epsilon(0.14));
      CHECK(std::abs(sum / count) <= 5.0 / 6.0 / std::sqrt(count));
    }
}

TEST_CASE("the error for exemplars that cannot be mixed gives the valid range or names them") {
  const MixedExemplar moss = exemplarOf("moss", 7), rock = exemplarOf("rock", 8);
  const auto message = [](const std::vector<MixedExemplar>& exemplars,
                          const TextonMixOptions& options, ErrorKind kind) {
    const Result<TextonMixBake> bake = bakeTextonMix("mix", exemplars, options);
    REQUIRE(!bake);
    CHECK(bake.error().kind == kind);
    return bake.error().message;
  };
  CHECK(message({moss}, smallOptions(3), ErrorKind::usage) ==
        "exemplars to mix: 1; expected 2 to 16");
  CHECK(message(std::vector<MixedExemplar>(17, moss), smallOptions(3), ErrorKind::usage) ==
        "exemplars to mix: 17; expected 2 to 16");
  CHECK(message({moss, rock}, smallOptions(1), ErrorKind::usage) ==
        "steps from an exemplar to the next: 1; expected 2 to 64 for 2 exemplars, at most 64 "
        "textons in all");
  CHECK(message({moss, rock, moss}, smallOptions(33), ErrorKind::usage) ==
        "steps from an exemplar to the next: 33; expected 2 to 32 for 3 exemplars, at most 64 "
        "textons in all");
  MixedExemplar set = rock;
  set.maps.push_back({MapTarget::height,
                      {MapChannel::height},
                      ValueEncoding::linear,
                      2,
                      2,
                      {0.0f, 0.5f, 0.5f, 1.0f}});
  CHECK(message({moss, set}, smallOptions(3), ErrorKind::badInput) ==
        "rock: has height, which moss does not have; expected the same maps in all exemplars");
  CHECK(message({set, moss}, smallOptions(3), ErrorKind::badInput) ==
        "moss: has no height, which rock has; expected the same maps in all exemplars");
  MixedExemplar bright = rock;
  bright.maps[0].encoding = ValueEncoding::log2;
  CHECK(message({moss, bright}, smallOptions(3), ErrorKind::badInput) ==
        "rock: baseColor is stored as log2, in moss as srgb; expected the same maps in all "
        "exemplars");
  MixedExemplar tall = rock;
  tall.maps[0] = cropped(rock.maps[0], 0, 0, 1, 48);
  MixedExemplar wide{"wide", {threeMaterials(400, 4, 1)}};
  CHECK(message({wide, tall}, smallOptions(3), ErrorKind::badInput) ==
        "rock: 1 x 48 pixels become 400 x 19200 at the widest exemplar's width; expected a "
        "height of at most 16384");
  TextonMixOptions large = smallOptions(64);
  large.texton.support = 300;
  const MixedExemplar big = exemplarOf("big", 1, 3, 300);
  CHECK(message({big, big}, large, ErrorKind::usage) ==
        "64 steps of 384 rows each make an image of 24576; expected at most 16384; use "
        "fewer steps or a smaller support");
  TextonMixOptions weights = smallOptions(3);
  weights.weights = {1.0};
  CHECK(message({moss, rock}, weights, ErrorKind::usage) ==
        "weights: 1 for 2 exemplars; expected one per exemplar");
}
