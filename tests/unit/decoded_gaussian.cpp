// SPDX-License-Identifier: MIT
// The decoded mean of a Gaussian value that has lost a part of its variance, against sums over the
// Gaussian.
#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace lichen;

namespace {

constexpr shader::uint kSrgb = LICHEN_ENCODING_SRGB, kLinear = LICHEN_ENCODING_LINEAR;

double decoded(double x, shader::uint encoding) {
  if (encoding == LICHEN_ENCODING_LOG2)
    return std::exp2(std::clamp(x, 0.0, 16.0)) - 1.0;
  x = std::clamp(x, 0.0, 1.0);
  if (encoding == LICHEN_ENCODING_LINEAR)
    return x;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

/// By the midpoint rule over eight standard deviations in each direction.
double meanDecoded(double stored, double deviation, shader::uint encoding) {
  constexpr int kSteps = 4000;
  double sum = 0.0, weights = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double e = 16.0 * (k + 0.5) / kSteps - 8.0;
    const double weight = std::exp(-0.5 * e * e);
    sum += weight * decoded(stored + deviation * e, encoding);
    weights += weight;
  }
  return sum / weights;
}

/// A map of one channel with this mean and standard deviation.
shader::LichenMap mapOf(double mean, double deviation, shader::uint encoding) {
  shader::LichenMap map{};
  map.encoding = encoding;
  map.decoding = LICHEN_DECODING_GAUSSIAN;
  map.row0 = {float(6.0 * deviation), 0.0f, 0.0f, float(mean)};
  return map;
}

} // namespace

TEST_CASE("the decoded value is the mean over the lost variance, for any mean and deviation, also "
          "where contrast loses more than the whole variance") {
  for (const shader::uint encoding : {kSrgb, kLinear})
    for (const double mean : {-0.05, 0.0, 0.02, 0.2, 0.5, 0.8, 1.0, 1.1})
      for (const double deviation : {0.01, 0.05, 0.1, 0.2})
        for (const float lost : {0.1f, 1.0f, 4.0f}) {
          const auto value = decodedGaussian(mapOf(mean, deviation, encoding), {0.5f, 0.5f, 0.5f},
                                             {lost, 0.0f, 0.0f});
          const double hidden = deviation * std::sqrt(double(lost));
          INFO("mean " << mean << ", deviation " << deviation << ", lost " << lost);
          // The error of the polynomial that replaces the sRGB curve; for linear values, only
          // rounding.
          const double tolerance = encoding == kSrgb ? 6e-4 : 1e-6;
          CHECK(double(value[0]) == Approx(meanDecoded(mean, hidden, encoding)).margin(tolerance));
        }
}

TEST_CASE("the mean of logarithmic light is the mean of its powers") {
  for (const double mean : {-0.5, 0.0, 0.3, 2.0, 8.0})
    for (const double deviation : {0.01, 0.3, 1.0}) {
      const auto value =
          decodedGaussian(mapOf(mean, deviation, LICHEN_ENCODING_LOG2), {0.5f, 0.5f, 0.5f}, {1.0f});
      INFO("mean " << mean << ", deviation " << deviation);
      // The midpoint rule's error at the corner, with steps of 0.004 standard deviations.
      CHECK(double(value[0]) ==
            Approx(meanDecoded(mean, deviation, LICHEN_ENCODING_LOG2)).epsilon(1e-4).margin(1e-5));
    }
}

TEST_CASE("without lost variance the value is the decoded one; slopes return the lost variance") {
  for (const shader::uint encoding : {kSrgb, kLinear, shader::uint(LICHEN_ENCODING_LOG2)})
    for (const double mean : {0.0, 0.03, 0.4, 1.0}) {
      const auto value = decodedGaussian(mapOf(mean, 0.1, encoding), {0.5f, 0.5f, 0.5f}, {});
      // A standard deviation of 1e-6 stands for 0.
      CHECK(double(value[0]) == Approx(decoded(mean, encoding)).margin(2e-6));
    }
  shader::LichenMap slopes = mapOf(0.2, 0.1, LICHEN_ENCODING_SLOPE);
  slopes.row1 = {0.0f, 1.8f, 0.0f, -0.3f};
  const auto value = decodedGaussian(slopes, {0.5f, 0.5f, 0.5f}, {0.5f, 0.25f, 1.0f});
  CHECK(value[0] == Approx(0.2));
  CHECK(value[1] == Approx(-0.3));
  CHECK(value[2] == Approx((0.5 * 0.01 + 0.25 * 0.09) / 2.0));
}
