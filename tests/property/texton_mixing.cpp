// SPDX-License-Identifier: MIT
// Textons between exemplars: the ends of a mix, its covariances, and its smoothness.
#include "example_exemplar.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <texton/coefficients.h>
#include <texton/mixing.h>
#include <transport/covariance.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::texton;
using Eigen::MatrixXd;

namespace {

MixExemplar exemplarOf(const MapExemplar& map, std::string name = "exemplar") {
  const auto channels = Eigen::Index(map.channels.size());
  const Eigen::Map<const Eigen::MatrixXf> values(map.values.data(), channels,
                                                 Eigen::Index(map.values.size()) / channels);
  const Eigen::VectorXd mean = values.cast<double>().rowwise().mean();
  const MatrixXd centred = values.cast<double>().colwise() - mean;
  return {std::move(name), texton::gaussianModel(map.values, map.width, map.height, int(channels)),
          centred * centred.transpose() / double(values.cols())};
}

MapExemplar constant(int width, int height) {
  MapExemplar map = threeMaterials(width, height, 1);
  for (std::size_t i = 0; i < map.values.size(); ++i)
    map.values[i] = 0.25f + 0.25f * float(i % 3);
  return map;
}

/// The luminance of the map as colour: one axis of three.
MapExemplar greyed(MapExemplar map) {
  for (std::size_t i = 0; i < map.values.size(); i += 3)
    map.values[i] = map.values[i + 1] = map.values[i + 2];
  return map;
}

FitOptions support(int side, int order = 1) {
  FitOptions options;
  options.width = side;
  options.height = side;
  options.order = order;
  return options;
}

TextonMix pathOf(std::span<const MixExemplar> exemplars, int stepsPerLeg,
                 const FitOptions& options) {
  Result<TextonMix> result = fitTextonPath(exemplars, stepsPerLeg, options);
  INFO((result ? "" : result.error().message));
  REQUIRE(result);
  return std::move(result).value();
}

/// Length of the difference over the root mean square length of both.
double relativeStep(const TextonCoefficients& a, const TextonCoefficients& b) {
  double difference = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    difference += std::pow(double(a.values[i]) - double(b.values[i]), 2);
    size += (std::pow(double(a.values[i]), 2) + std::pow(double(b.values[i]), 2)) / 2.0;
  }
  return std::sqrt(difference / size);
}

std::string messageOf(const Result<TextonMix>& result, ErrorKind kind) {
  REQUIRE(!result);
  CHECK(result.error().kind == kind);
  return result.error().message;
}

} // namespace

TEST_CASE("the textons at the ends of a path have nearly the error of separate fits") {
  // Sharing one phase per frequency between two spectra costs up to 7 % here and 1 % on
  // photographs. A low-contrast exemplar is not neglected.
  for (const int order : {0, 1, 3}) {
    MapExemplar faint = threeMaterials(64, 64, 7);
    for (float& value : faint.values)
      value *= 0.1f;
    const std::vector<MixExemplar> exemplars{exemplarOf(faint),
                                             exemplarOf(threeMaterials(64, 64, 8, 1))};
    const TextonMix mix = pathOf(exemplars, 4, support(24, order));
    REQUIRE(mix.steps.size() == 5);
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
      const MixStep& step = mix.steps[4 * end];
      CHECK(step.weights[end] == 1.0);
      std::vector<double> alone(2, 0.0);
      alone[end] = 1.0;
      const Result<TextonMix> single = fitTextonBarycenter(exemplars, alone, support(24, order));
      REQUIRE(single);
      INFO("order " << order << ", end " << end);
      CHECK(step.errors.all < 1.1 * single.value().steps[0].errors.all);
    }
  }
}

TEST_CASE("every step has the covariance of the exemplars' transport barycentre") {
  const std::vector<MixExemplar> exemplars{exemplarOf(threeMaterials(32, 32, 7)),
                                           exemplarOf(threeMaterials(32, 32, 9))};
  const TextonMix mix = pathOf(exemplars, 5, support(12));
  const MatrixXd map = transport::covarianceMap(exemplars[0].covariance, exemplars[1].covariance);
  for (const MixStep& step : mix.steps) {
    const MatrixXd line = step.weights[0] * MatrixXd::Identity(3, 3) + step.weights[1] * map;
    const MatrixXd expected = line * exemplars[0].covariance * line;
    // The accuracy that correctCovariance states, and the rounding of the pseudo-inverses.
    CHECK((noiseCovariance(step.texton, 1) - expected).norm() < 1e-5 * expected.norm());
  }
}

TEST_CASE("a path can end at a grey exemplar stored as colour and at one of a single colour") {
  const MixExemplar color = exemplarOf(threeMaterials(32, 32, 7));
  const MixExemplar grey = exemplarOf(greyed(threeMaterials(32, 32, 9)));
  for (const auto& [first, second] : {std::pair{grey, color}, {color, grey}, {grey, grey}}) {
    const TextonMix mix = pathOf(std::vector{first, second}, 4, support(12));
    const TextonCoefficients& end = mix.steps[0].texton;
    CHECK((noiseCovariance(end, 1) - first.covariance).norm() < 1e-5 * first.covariance.norm());
    const std::size_t plane = end.values.size() / 3;
    if (transport::rank(first.covariance) == 1)
      for (std::size_t i = 0; i < plane; ++i)
        CHECK(end.values[i] == Approx(end.values[2 * plane + i]).margin(1e-5));
  }
  const MixExemplar flat = exemplarOf(constant(32, 32));
  const TextonMix mix = pathOf(std::vector{flat, color}, 4, support(12));
  for (const float value : mix.steps[0].texton.values)
    CHECK(std::abs(value) < 1e-6f);
  // The standard deviation grows linearly, and the texture remains the exemplar's throughout.
  for (const MixStep& step : mix.steps) {
    const MatrixXd expected = step.weights[1] * step.weights[1] * color.covariance;
    CHECK((noiseCovariance(step.texton, 1) - expected).norm() <= 1e-5 * color.covariance.norm());
    if (step.weights[1] > 0.0)
      CHECK(step.errors.all == Approx(mix.steps.back().errors.all).epsilon(1e-3));
  }
  for (const MixStep& step : pathOf(std::vector{flat, flat}, 4, support(12)).steps)
    for (const float value : step.texton.values)
      CHECK(std::abs(value) < 1e-6f);
}

TEST_CASE("neighbouring textons of a path differ much less than separate fits") {
  const std::vector<MixExemplar> exemplars{exemplarOf(threeMaterials(48, 48, 7)),
                                           exemplarOf(threeMaterials(48, 48, 8, 1))};
  const TextonMix mix = pathOf(exemplars, 20, support(16));
  double longest = 0.0;
  double sum = 0.0;
  double alone = 0.0;
  double error = 0.0;
  double errorAlone = 0.0;
  TextonCoefficients last;
  for (std::size_t k = 0; k < mix.steps.size(); ++k) {
    const MixStep& step = mix.steps[k];
    // As in [GLM17]: all fits have the same start.
    const Result<TextonMix> fitted = fitTextonBarycenter(exemplars, step.weights, support(16));
    REQUIRE(fitted);
    error += step.errors.all;
    errorAlone += fitted.value().steps[0].errors.all;
    if (k > 0) {
      const double length = relativeStep(mix.steps[k - 1].texton, step.texton);
      longest = std::max(longest, length);
      sum += length;
      alone += relativeStep(last, fitted.value().steps[0].texton);
    }
    last = fitted.value().steps[0].texton;
  }
  // A straight line of 20 steps between two textons of similar length and non-negative product is
  // at most sqrt(2) long. It is nearest to zero in the middle, by a factor of sqrt(2).
  CHECK(longest < 2.0 / 20.0);
  CHECK(sum < 0.2 * alone);
  CHECK(error < 1.05 * errorAlone);
}

TEST_CASE("a path goes through all exemplars, and exemplars of other sizes use its tile") {
  const std::vector<MixExemplar> exemplars{exemplarOf(threeMaterials(32, 24, 1)),
                                           exemplarOf(threeMaterials(16, 16, 2, 1)),
                                           exemplarOf(threeMaterials(30, 40, 3))};
  const TextonMix mix = pathOf(exemplars, 3, support(10));
  REQUIRE(mix.steps.size() == 7);
  CHECK(mix.steps[0].texton.width == 10);
  const TextonMix whole = pathOf(exemplars, 1, support(40));
  CHECK(whole.steps[0].texton.width == 32);
  CHECK(whole.steps[0].texton.height == 40);
  for (std::size_t k = 0; k < 3; ++k) {
    const MixStep& step = mix.steps[3 * k];
    CHECK(step.weights[k] == 1.0);
    CHECK((noiseCovariance(step.texton, 1) - exemplars[k].covariance).norm() <
          1e-5 * exemplars[k].covariance.norm());
  }
  CHECK(mix.steps[4].weights == std::vector{0.0, 1.0 - 1.0 / 3.0, 1.0 / 3.0});
  // Weights with any sum, for more than two exemplars; one kernel is enough for three.
  const Result<TextonMix> inside =
      fitTextonBarycenter(exemplars, std::vector{2.0, 1.0, 1.0}, support(10));
  REQUIRE(inside);
  CHECK(inside.value().steps[0].weights == std::vector{0.5, 0.25, 0.25});
  CHECK(inside.value().steps[0].rankError < 0.05);
  CHECK(inside.value().steps[0].errors.all < 1.0);
}

TEST_CASE("the error for exemplars that cannot be mixed gives the reason") {
  const MixExemplar color = exemplarOf(threeMaterials(16, 16, 1), "moss.png");
  const std::vector<MixExemplar> pair{color, exemplarOf(threeMaterials(32, 12, 2), "rust.png")};
  CHECK(messageOf(fitTextonBarycenter(pair, std::vector{1.0}, support(8)), ErrorKind::usage) ==
        "weights: 1 for 2 exemplars; expected one per exemplar");
  CHECK(messageOf(fitTextonBarycenter(pair, std::vector{1.0, -0.5}, support(8)),
                  ErrorKind::usage) == "a weight of -0.5; expected 0 or more");
  CHECK(messageOf(fitTextonBarycenter(pair, std::vector{0.0, 0.0}, support(8)), ErrorKind::usage) ==
        "weights of sum 0; expected a sum above 0");
  // One coefficient correlates all channels fully, unlike the exemplars'.
  CHECK(messageOf(fitTextonPath(pair, 1, support(1)), ErrorKind::badInput) ==
        "a mix of 1 moss.png, 0 rust.png: 1 x 1 coefficients cannot vary as these colours do; "
        "use a larger texton, or exemplars with detail");
  // The periodic component removes a ramp entirely.
  MapExemplar ramp = constant(256, 16);
  for (std::size_t i = 0; i < ramp.values.size(); ++i)
    ramp.values[i] = float(i / 3 % 256) / 255.0f;
  const std::vector<MixExemplar> ramps{color, exemplarOf(ramp, "ramp.png")};
  CHECK(messageOf(fitTextonPath(ramps, 1, support(8)), ErrorKind::badInput) ==
        "ramp.png: varies only from one border to the other, which no texton can reproduce; use a "
        "photograph with detail");
}
