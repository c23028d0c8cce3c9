// SPDX-License-Identifier: MIT
// The shader library's decoding without a table of a Gaussian value that has lost a part of its
// variance, against sums over the Gaussian.
#define LICHEN_METHODS 1
#include "evaluation/shader_library.h"

#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

using namespace lichen;

namespace {

constexpr shader::uint kRoot = LICHEN_ENCODING_ROOT, kLinear = LICHEN_ENCODING_LINEAR,
                       kLog2 = LICHEN_ENCODING_LOG2;

std::array<float, 4> decodedGaussian(const shader::LichenMap& map, std::array<float, 3> gaussian,
                                     std::array<float, 3> lost) {
  const auto vectorOf = [](const std::array<float, 3>& v) { return glsl::vec3(v[0], v[1], v[2]); };
  glsl::ShaderLibrary library;
  const glsl::vec4 value = library.lichenDecodeGaussian(
      vectorOf(gaussian), vectorOf(lost), std::bit_cast<glsl::ShaderLibrary::LichenMap>(map));
  return {value.x.v, value.y.v, value.z.v, value.w.v};
}

double decoded(double x, shader::uint encoding) {
  if (encoding == LICHEN_ENCODING_LOG2)
    return std::exp2(x) - 1.0;
  return encoding == LICHEN_ENCODING_LINEAR ? x : x * x;
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
  for (const shader::uint encoding : {kRoot, kLinear, kLog2})
    for (const double mean : {0.0, 0.02, 0.2, 0.5, 0.8, 1.0})
      for (const double deviation : {0.01, 0.05, 0.1, 0.2})
        for (const float lost : {0.1f, 1.0f, 4.0f}) {
          const auto value = decodedGaussian(mapOf(mean, deviation, encoding), {0.5f, 0.5f, 0.5f},
                                             {lost, 0.0f, 0.0f});
          const double hidden = deviation * std::sqrt(double(lost));
          INFO("mean " << mean << ", deviation " << deviation << ", lost " << lost);
          // Rounding of floats, the only error of closed forms.
          CHECK(double(value[0]) == Approx(meanDecoded(mean, hidden, encoding)).margin(1e-6));
        }
}

TEST_CASE("roots below 0 are squared without a clamp, since a clamp would move the mean") {
  // The mean of the squares of Gaussian roots about 0.05, of deviation 0.1, is their sum of
  // squares.
  const shader::LichenMap map = mapOf(0.05, 0.1, kRoot);
  double sum = 0.0, weights = 0.0;
  for (double deviations = -8.0; deviations <= 8.0; deviations += 1.0 / 64.0) {
    const double weight = std::exp(-0.5 * deviations * deviations);
    const auto gaussian = float(0.5 + deviations / 6.0);
    sum += weight * double(decodedGaussian(map, {gaussian, 0.5f, 0.5f}, {})[0]);
    weights += weight;
  }
  CHECK(sum / weights == Approx(0.05 * 0.05 + 0.1 * 0.1).epsilon(1e-5));
}

TEST_CASE("values outside of the range of their encoding are clamped, and light stays finite") {
  const auto valueOf = [](double stored, shader::uint encoding) {
    return decodedGaussian(mapOf(stored, 0.1, encoding), {0.5f, 0.5f, 0.5f}, {})[0];
  };
  CHECK(valueOf(-0.1, kLinear) == 0.0f);
  CHECK(valueOf(1.1, kLinear) == 1.0f);
  CHECK(valueOf(-0.5, kLog2) == 0.0f);
  CHECK(valueOf(200.0, kLog2) == 65535.0f);
}

TEST_CASE("without lost variance the value is the decoded one; slopes return the lost variance") {
  for (const shader::uint encoding : {kRoot, kLinear, kLog2})
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
