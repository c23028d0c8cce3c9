// SPDX-License-Identifier: MIT
// Regular patterns that multiple-kernels noise perturbs: their waves against pictures, splines and
// exemplars of known waves, and the covariance and the spectrum of both together.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/multiple_kernels.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <limits>
#include <numbers>
#include <random>
#include <set>

using namespace lichen;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double valueOf(const std::vector<PatternWave>& waves, double x, double y) {
  double sum = 0.0;
  for (const PatternWave& wave : waves)
    sum += wave.amplitude * std::cos(kTurn * (wave.u * x + wave.v * y + wave.phase));
  return sum;
}

/// A grey exemplar of a few waves, and of Gaussian noise of the deviation `noise`.
MapExemplar ofWaves(int width, int height, const std::vector<PatternWave>& waves, double noise) {
  MapExemplar map = test::threeMaterials(width, height, 3);
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  map.encoding = ValueEncoding::linear;
  map.values.clear();
  std::mt19937 generator(7u);
  std::normal_distribution<double> gaussian(0.0, noise);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      map.values.push_back(float(0.5 + valueOf(waves, (x + 0.5) / width, (y + 0.5) / height) +
                                 (noise > 0.0 ? gaussian(generator) : 0.0)));
  return map;
}

Bundle perturbed(const MapExemplar& map, Perturbation perturbation,
                 GaussianOnly gaussian = GaussianOnly::yes) {
  MultipleKernelsOptions options;
  options.gaussian = gaussian;
  options.periodic = Periodic::yes;
  options.perturbation = std::move(perturbation);
  return test::bundleOf(bakeMultipleKernels("x", {&map, 1}, options));
}

const MultipleKernelsNoise& sharedOf(const Bundle& bundle) {
  return bundle.noises[0].as<MultipleKernelsNoise>();
}
const Table& imageOf(const Bundle& bundle) {
  return bundle.tables[bundle.noises[0].maps[0].as<MultipleKernelsMap>().kernels];
}

/// The covariance that an image says, in squared deviations.
Eigen::Matrix3d covarianceOf(const Bundle& bundle) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const KernelRow& row : kernelRows(imageOf(bundle), sharedOf(bundle)))
    for (std::size_t s = 0; s < 4; ++s) {
      const Eigen::Vector3d color(double(row.colors[0][s]), double(row.colors[1][s]),
                                  double(row.colors[2][s]));
      covariance += 36.0 * color * color.transpose();
    }
  for (const PatternCosine& cosine : patternCosines(imageOf(bundle), sharedOf(bundle)))
    for (std::size_t part = 0; part < 2; ++part) {
      const Eigen::Vector3d wave(double(cosine.waves[0][part]), double(cosine.waves[1][part]),
                                 double(cosine.waves[2][part]));
      covariance += 18.0 * wave * wave.transpose();
    }
  return covariance;
}

} // namespace

TEST_CASE("the waves of a picture are its Fourier series") {
  constexpr int kWidth = 12, kHeight = 9;
  SrgbImage picture(kWidth, kHeight, 1);
  std::mt19937 generator(1u);
  std::uniform_real_distribution<float> code(0.0f, 1.0f);
  for (float& value : picture.values)
    value = code(generator);
  // Without the highest frequency of the even side, which has no mirror.
  for (int y = 0; y < kHeight; ++y) {
    float alternating = 0.0f;
    for (int x = 0; x < kWidth; ++x)
      alternating += (x % 2 == 0 ? 1.0f : -1.0f) / kWidth *
                     picture.values[std::size_t(y) * kWidth + std::size_t(x)];
    for (int x = 0; x < kWidth; ++x)
      picture.values[std::size_t(y) * kWidth + std::size_t(x)] -=
          (x % 2 == 0 ? 1.0f : -1.0f) * alternating;
  }
  double mean = 0.0;
  for (const float value : picture.values)
    mean += double(value) / (kWidth * kHeight);
  for (const int repeats : {1, 3}) {
    const std::vector<PatternWave> waves = patternOf(picture, repeats, 1000);
    CHECK(waves.size() == (kWidth * kHeight - kHeight - 1) / 2);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        CHECK(valueOf(waves, (x + 0.5) / kWidth / repeats, (y + 0.5) / kHeight / repeats) ==
              Approx(double(picture.values[std::size_t(y) * kWidth + std::size_t(x)]) - mean)
                  .margin(1e-5));
  }
  const std::vector<PatternWave> few = patternOf(picture, 1, 5);
  CHECK(few.size() == 5);
  CHECK(few.front().amplitude >= few.back().amplitude);
}

TEST_CASE("a spline has the waves of a cubic B-spline") {
  const std::vector<double> points{0.2, 1.0, -0.4, 0.7, 0.1};
  const std::vector<PatternWave> waves = patternOfSpline(2, -3, points);
  const auto count = int(points.size());
  double mean = 0.0;
  for (const double point : points)
    mean += point / count;
  // At the knots a cubic B-spline is (p[k - 1] + 4 p[k] + p[k + 1]) / 6.
  for (int k = 0; k < count; ++k) {
    const auto point = [&](int index) { return points[std::size_t((index + count) % count)]; };
    const double expected = (point(k - 1) + 4.0 * point(k) + point(k + 1)) / 6.0 - mean;
    // The harmonics above the number of points, which are left out, have a thousandth.
    CHECK(valueOf(waves, double(k) / count / 2.0, 0.0) == Approx(expected).margin(5e-3));
    CHECK(valueOf(waves, 0.0, double(k) / count / -3.0) == Approx(expected).margin(5e-3));
  }
}

TEST_CASE("waves of one frequency and of its mirror add up") {
  const std::vector<PatternWave> sum = strongestWaves(std::vector<PatternWave>{{5, 3, 1.0, 0.1},
                                                                               {-5, -3, 1.0, -0.1},
                                                                               {0, 4, 0.5, 0.0},
                                                                               {0, -4, 0.5, 0.5},
                                                                               {2, 0, 0.3, 0.75}},
                                                      2);
  REQUIRE(sum.size() == 2);
  CHECK(sum[0].u == 5);
  CHECK(sum[0].v == 3);
  CHECK(sum[0].amplitude == Approx(2.0));
  CHECK(sum[0].phase == Approx(0.1));
  CHECK(sum[1].u == 2); // the two at (0, 4) cancel
}

TEST_CASE("patterns that cannot be are refused") {
  const MapExemplar map = test::threeMaterials(32, 32, 3);
  const double infinity = std::numeric_limits<double>::infinity();
  SrgbImage grey(300, 300, 1);
  std::fill(grey.values.begin(), grey.values.end(), 0.4f);
  const auto messageOf = [&](std::vector<PatternWave> pattern, double amount, int cosines) {
    MultipleKernelsOptions options;
    options.perturbation = Perturbation{amount, std::move(pattern), cosines};
    const auto baked = bakeMultipleKernels("x", {&map, 1}, options);
    REQUIRE(!baked);
    return baked.error().message;
  };
  using Catch::Contains;
  CHECK_THAT(messageOf({{8, 0, 1.0, 0.0}, {8, 0, 1.0, 0.5}}, 1.0, 40), Contains("does not vary"));
  CHECK_THAT(messageOf(patternOf(grey, 1, 40), 1.0, 40), Contains("does not vary"));
  CHECK_THAT(messageOf({{0, 0, 1.0, 0.0}}, 1.0, 40), Contains("frequency 0"));
  CHECK_THAT(messageOf({{20000, 1, 1.0, 0.0}}, 1.0, 40), Contains("20000"));
  CHECK_THAT(messageOf({{2, 1, infinity, 0.0}}, 1.0, 40), Contains("not finite"));
  CHECK_THAT(messageOf({}, -1.0, 40), Contains("-1") && Contains("0 to 16"));
  CHECK_THAT(messageOf({}, 1.0, 97), Contains("97") && Contains("96"));
}

TEST_CASE("without noise a pattern of the exemplar's waves is the exemplar") {
  const std::vector<PatternWave> waves{{3, 2, 0.1, 0.1}, {0, 5, 0.05, 0.4}, {7, -4, 0.07, 0.8}};
  const MapExemplar map = ofWaves(64, 48, waves, 0.0);
  Perturbation perturbation;
  perturbation.amount = 0.0;
  perturbation.cosines = 3;
  const Bundle bundle = perturbed(map, perturbation);
  std::set<std::pair<float, float>> found;
  for (const PatternCosine& cosine : patternCosines(imageOf(bundle), sharedOf(bundle)))
    found.insert({cosine.frequency[0], cosine.frequency[1]});
  CHECK(found == std::set<std::pair<float, float>>{{3.0f, 2.0f}, {0.0f, 5.0f}, {7.0f, -4.0f}});
  const auto evaluator = methodEvaluator(bundle, 0);
  Placement placement;
  placement.tileOriginX = 1000000007; // the pattern repeats with the tile
  const shader::LichenTriplanarMaterial material =
      shaderMaterial(bundle, MaterialNoise(), placement);
  for (int y = 0; y < 48; y += 5)
    for (int x = 0; x < 64; x += 3) {
      // Transforms take the place of a pixel for its corner.
      const TileFootprint at{{float(x) / 64.0f, float(y) / 48.0f}, {}, {}};
      CHECK(double(evaluator->evaluate(0, material, at)[0]) ==
            Approx(double(map.values[std::size_t(64 * y + x)])).margin(2e-3));
    }
}

TEST_CASE("noise has what a pattern leaves of the spectrum") {
  // Half of the variance in one wave; the noise is white.
  const double deviation = 0.1;
  const MapExemplar map = ofWaves(64, 64, {{5, 3, deviation * std::sqrt(2.0), 0.2}}, deviation);
  Perturbation perturbation;
  perturbation.cosines = 1;
  const Bundle bundle = perturbed(map, perturbation);
  const std::vector<PatternCosine> pattern = patternCosines(imageOf(bundle), sharedOf(bundle));
  REQUIRE(pattern.size() == 1);
  const auto [a, b] = pattern[0].waves[0];
  CHECK(18.0 * (double(a) * double(a) + double(b) * double(b)) == Approx(0.5).margin(0.03));
  double noise = 0.0;
  for (const KernelRow& row : kernelRows(imageOf(bundle), sharedOf(bundle)))
    for (const float factor : row.colors[0])
      noise += 36.0 * double(factor) * double(factor);
  CHECK(noise == Approx(0.5).margin(0.03));
}

TEST_CASE("pattern and noise together have the exemplar's covariance, however strong the noise") {
  const MapExemplar map = test::threeMaterials(96, 64, 3);
  for (const bool isGiven : {false, true})
    for (const double amount : {0.0, 0.25, 1.0, 4.0}) {
      Perturbation perturbation;
      perturbation.amount = amount;
      if (isGiven)
        perturbation.pattern = {{4, 0, 1.0, 0.0}, {0, 4, 1.0, 0.0}};
      const Bundle bundle = perturbed(map, perturbation, GaussianOnly::no);
      INFO("given " << isGiven << ", amount " << amount);
      const Eigen::Matrix3d covariance = covarianceOf(bundle);
      CHECK((covariance - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 0.03);
    }
}

TEST_CASE("a given pattern shows in the luminance of the noise, as strong as the noise") {
  const MapExemplar map = test::threeMaterials(96, 64, 3);
  Perturbation perturbation;
  perturbation.pattern = {{4, 0, 1.0, 0.25}};
  const Bundle bundle = perturbed(map, perturbation, GaussianOnly::no);
  const auto evaluator = methodEvaluator(bundle, 0);
  const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, MaterialNoise(), {});
  std::mt19937 generator(2u);
  std::uniform_real_distribution<float> tiles(-30.0f, 30.0f);
  double sum = 0.0, squares = 0.0, product = 0.0, waves = 0.0;
  constexpr int kSamples = 20000;
  for (int sample = 0; sample < kSamples; ++sample) {
    const float x = tiles(generator);
    const auto value =
        evaluator->evaluate(0, material, TileFootprint{{x, tiles(generator)}, {}, {}});
    const double luminance =
        0.2126 * double(value[0]) + 0.7152 * double(value[1]) + 0.0722 * double(value[2]);
    const double wave = std::sqrt(2.0) * std::cos(kTurn * (4.0 * double(x) + 0.25));
    sum += luminance;
    squares += luminance * luminance;
    product += luminance * wave;
    waves += wave * wave;
  }
  const double variance = squares / kSamples - std::pow(sum / kSamples, 2.0);
  const double correlation = product / kSamples / std::sqrt(variance * waves / kSamples);
  // Half of the variance, and what the table bends.
  CHECK(correlation > 0.6);
  CHECK(correlation < std::sqrt(0.5) + 0.03);
}
