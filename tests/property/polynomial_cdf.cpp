// SPDX-License-Identifier: MIT
// The polynomial distribution function of evaluators against the error function, and what it leaves
// of a table's tails.
#include <lichen/tiling.h>
#include <lichen/tiling_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <gaussianization/polynomial_cdf.h>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::gaussianization;

namespace {

double exactCdf(double value) { return 0.5 * std::erfc(-6.0 * (value - 0.5) / std::sqrt(2.0)); }

} // namespace

TEST_CASE(
    "the polynomial distribution function is within 1.9e-4 of the exact one, where a table of "
    "256 cells has lookups between centres") {
  double largest = 0.0;
  for (int k = 0; k <= 100000; ++k) {
    const double value = k / 100000.0;
    const double exact = std::clamp(exactCdf(value), 0.5 / 256.0, 1.0 - 0.5 / 256.0);
    largest = std::max(largest, std::abs(double(polynomialCdf(float(value))) - exact));
  }
  CHECK(largest < 1.9e-4);
  CHECK(largest > 1.0e-4); // as documented, not more exact
}

TEST_CASE("the polynomial distribution function never decreases and is odd about the middle") {
  float before = -1.0f;
  for (int k = -20000; k <= 120000; ++k) {
    const float value = float(k) / 100000.0f;
    const float here = polynomialCdf(value);
    REQUIRE(here >= before - 1e-7f); // the rounding of floats
    REQUIRE(here + polynomialCdf(1.0f - value) == Approx(1.0f).epsilon(1e-6));
    before = here;
  }
}

TEST_CASE("the polynomial distribution function reaches the outermost centres of 256 cells") {
  // To a twentieth of a cell, beyond which lookups are constant.
  CHECK(256.0 * double(polynomialCdf(0.0f)) == Approx(0.5).margin(0.05));
  CHECK(256.0 * double(polynomialCdf(1.0f)) == Approx(255.5).margin(0.05));
}

TEST_CASE("the outermost thousandths of a map of one channel come out of its table") {
  // Values of an exponential distribution, whose upper tail is long, in random order. At a
  // thousandth of the distribution a cell of 256 holds the mean of four times as much: a value
  // beyond the quantile of 1/256 becomes their mean.
  constexpr int kSide = 256, kPixels = kSide * kSide;
  MapExemplar map;
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  map.encoding = ValueEncoding::linear;
  map.width = map.height = kSide;
  const auto quantile = [](double u) { return 0.1 - 0.1 * std::log(1.0 - u); };
  for (int i = 0; i < kPixels; ++i)
    map.values.push_back(float(quantile((i + 0.5) / kPixels)));
  for (std::size_t i = kPixels; i-- > 1;)
    std::swap(map.values[i], map.values[transport::randomBits(7, i) % (i + 1)]);
  TilingOptions options;
  options.bits = 16;
  Result<TilingBake> bake = bakeTiling("tail", {&map, 1}, options);
  REQUIRE(bake);
  Bundle bundle;
  bundle.tables = std::move(bake.value().tables);
  bundle.noises = {std::move(bake.value().noise)};
  const Result<TilingEvaluator> evaluator = TilingEvaluator::create(bundle, 0);
  REQUIRE(evaluator);
  std::vector<float> values = evaluator.value().decodedTexels(0);
  std::sort(values.begin(), values.end());
  // An outermost cell holds the mean of its values, and the lookup is constant from its centre on.
  const double highest = quantile(255.0 / 256.0) + 0.1; // the mean beyond a quantile
  const double lowest = quantile(0.5 / 256.0);
  CHECK(double(values[std::size_t(0.999 * kPixels)]) == Approx(highest).epsilon(0.01));
  CHECK(double(values[std::size_t(0.001 * kPixels)]) == Approx(lowest).epsilon(0.01));
  // Within the cells, quantiles are those of the exemplar, to half of the next cell's difference.
  // The outermost cell averages 1/256 of the variance away, and restoring it stretches the table
  // about the mean, 0.2, by half of that; interpolation adds as much again.
  for (const double u : {0.01, 0.1, 0.5, 0.9, 0.99})
    CHECK(double(values[std::size_t(u * kPixels)]) ==
          Approx(quantile(u))
              .margin(0.5 * (quantile(u + 1.0 / 256.0) - quantile(u)) +
                      std::abs(quantile(u) - 0.2) / 256.0));
}
