// SPDX-License-Identifier: MIT
// Gaussian spot noise and Gaussian textures, against closed forms.
//
// The statistics are means over independent textures. Each must be within 4.5 of its estimated
// standard errors from the expected value: one false alarm in 150,000 each. The seeds are fixed.
#include "example_exemplar.h"

#include <lichen/spectrum.h>

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gaussian/gaussian_texture.h>
#include <gaussian/spot_noise.h>
#include <transport/random.h>
#include <utility>
#include <vector>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::gaussian;

namespace {

constexpr double kStandardErrors = 4.5;

/// Sums of up to 84 points' values, of magnitude 20 before the mean is subtracted: 2^-24 of that
/// for each of several operations. One impact more or less changes values by at least 0.01.
constexpr double kRounding = 1e-5;

/// Two correlated channels with a skewed distribution.
Spot skewedSpot(int width, int height) {
  Spot spot{width, height, 2, {}};
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  for (std::size_t i = 0; i < pixels; ++i)
    spot.values.push_back(float(std::pow(transport::randomUniform(1, i), 3.0)) - 0.1f);
  for (std::size_t i = 0; i < pixels; ++i)
    spot.values.push_back(0.5f * spot.values[i] + float(transport::randomUniform(2, i)) - 0.7f);
  return spot;
}

float at(const NoisePlanes& noise, int x, int y, int channel) {
  return noise.values[std::size_t((channel * noise.height + y) * noise.width + x)];
}

/// Mean and variance of a number of independent values.
class Sample {
public:
  void add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  void checkMean(double expected) const {
    const double mean = sum_ / count_;
    const double variance = squares_ / count_ - mean * mean;
    CHECK(mean == Approx(expected).margin(kStandardErrors * std::sqrt(variance / count_)));
  }

private:
  double count_ = 0.0;
  double sum_ = 0.0;
  double squares_ = 0.0;
};

constexpr std::array<std::pair<int, int>, 5> kLags{{{0, 0}, {1, 0}, {-2, 1}, {0, 3}, {2, 3}}};

GaussianModel modelOf(const MapExemplar& map) {
  return gaussianModel(map.values, map.width, map.height, int(map.channels.size()));
}

} // namespace

TEST_CASE("Gaussian white noise is normal, and white") {
  constexpr int kSide = 256;
  std::vector<float> noise = gaussianWhiteNoise({0, 0, kSide, kSide, false}, 5);
  const double count = double(noise.size());
  double alongRows = 0.0;
  double alongColumns = 0.0;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    alongRows += double(noise[i]) * double(noise[(i + 1) % noise.size()]) / count;
    alongColumns += double(noise[i]) * double(noise[(i + kSide) % noise.size()]) / count;
  }
  CHECK(std::abs(alongRows) < kStandardErrors / std::sqrt(count));
  CHECK(std::abs(alongColumns) < kStandardErrors / std::sqrt(count));
  std::sort(noise.begin(), noise.end());
  double distance = 0.0;
  for (std::size_t i = 0; i < noise.size(); ++i)
    distance = std::max(distance, std::abs(0.5 * std::erfc(-double(noise[i]) / std::sqrt(2.0)) -
                                           (double(i) + 0.5) / count));
  // Kolmogorov's law: exceeded with the probability 2 exp(-2 * 2.47^2) = 1e-5.
  CHECK(distance < 2.47 / std::sqrt(count));
}

TEST_CASE("a crop of a circular noise equals the plane's only if the margin contains the spot") {
  const Spot spot = skewedSpot(5, 6);
  const PixelDomain plane{2, 3, 30, 26, false};
  PixelDomain torus = plane;
  torus.periodic = true;
  const NoisePlanes a = gaussianSpotNoise(spot, torus, 8), b = gaussianSpotNoise(spot, plane, 8);
  int inside = 0, outside = 0; // how many differ
  for (int c = 0; c < 2; ++c)
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x) {
        const bool differs = std::abs(double(at(a, x, y, c)) - double(at(b, x, y, c))) >= kRounding;
        (x >= spot.width - 1 && y >= spot.height - 1 ? inside : outside) += differs ? 1 : 0;
      }
  CHECK(inside == 0);
  CHECK(outside > 0);
}

TEST_CASE("a Gaussian texture on the model's torus has its spectra and cross-spectra") {
  const GaussianModel model = modelOf(cropped(threeMaterials(64, 64, 7), 5, 3, 47, 40));
  const NoisePlanes noise = gaussianTexture(model, {0, 0, 47, 40, true}, 9);
  const std::size_t pixels = 47 * 40;
  std::vector<HalfSpectrum> spectra;
  for (std::size_t c = 0; c < 3; ++c)
    spectra.push_back(forwardFft(std::span(noise.values).subspan(c * pixels, pixels), 47, 40));
  // The same white noise drives all channels: F_c t_d = F_d t_c at each frequency.
  double rest = 0.0, size = 0.0;
  for (std::size_t i = 0; i < spectra[0].values.size(); ++i) {
    const auto a = spectra[0].values[i] * model.channels[1].values[i];
    const auto b = spectra[1].values[i] * model.channels[0].values[i];
    rest += double(std::norm(a - b));
    size += double(std::norm(a));
  }
  CHECK(rest < 1e-10 * size); // float rounding, squared
  // Powers relative to the expected ones are exponential with mean 1, one for each pair of mirrored
  // frequencies.
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<float> power = powerSpectrum(spectra[c]);
    Sample ratio;
    for (int v = 0; v < 40; ++v)
      for (int u = 1; u <= 47 / 2; ++u) {
        const std::size_t i = std::size_t(v) * 24 + std::size_t(u);
        ratio.add(double(power[i]) / double(std::norm(model.channels[c].values[i])));
      }
    ratio.checkMean(1.0);
  }
}

TEST_CASE("a Gaussian texture smaller than the model has the model's covariances") {
  const GaussianModel model = modelOf(cropped(threeMaterials(24, 24, 3), 2, 1, 13, 12));
  const PixelDomain domain{4, 4, 9, 12, false};
  std::array<Sample, kLags.size()> samples;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const NoisePlanes noise = gaussianTexture(model, domain, seed);
    REQUIRE(noise.width == 9);
    REQUIRE(noise.height == 12);
    for (std::size_t k = 0; k < kLags.size(); ++k) {
      const auto [lagX, lagY] = kLags[k];
      double sum = 0.0;
      int pairs = 0;
      for (int y = 0; y + lagY < noise.height; ++y) {
        for (int x = std::max(0, -lagX); x + std::max(0, lagX) < noise.width; ++x, ++pairs)
          sum += double(at(noise, x, y, 0)) * double(at(noise, x + lagX, y + lagY, 2));
      }
      samples[k].add(sum / pairs);
    }
  }
  // The model's transforms are divided by the root of the pixel count, so a mean is a sum.
  const std::vector<float> covariance =
      inverseFft(crossSpectrum(model.channels[0], model.channels[2]));
  for (std::size_t k = 0; k < kLags.size(); ++k) {
    const auto [lagX, lagY] = kLags[k];
    samples[k].checkMean(13.0 * 12.0 *
                         double(covariance[std::size_t(lagY * 13 + (lagX + 13) % 13)]));
  }
}

TEST_CASE("a Gaussian texture larger than the model has its covariances at short lags") {
  const MapExemplar map = threeMaterials(64, 64, 7);
  const GaussianModel model = modelOf(map);
  const NoisePlanes noise = gaussianTexture(model, {0, 0, 1000, 700, false}, 2);
  const std::vector<float> covariance =
      inverseFft(crossSpectrum(model.channels[0], model.channels[0]));
  const std::vector<double> measured =
      autocovariance(std::span(noise.values).first(std::size_t(700000)), 1000, 700, 4);
  // 14,000 patches of 7 pixels: a relative standard deviation of sqrt(2 / 14,000) = 1.2 %.
  const double variance = 64.0 * 64.0 * double(covariance[0]);
  for (std::size_t lag = 0; lag < 4; ++lag)
    CHECK(measured[3 * 7 + 3 + lag] ==
          Approx(64.0 * 64.0 * double(covariance[lag])).margin(kStandardErrors * 0.012 * variance));
}

TEST_CASE("spot noises are the same bytes on one thread and on many") {
  const Spot spot = skewedSpot(9, 8);
  const PixelDomain domain{0, 0, 61, 53, false};
  const auto many = gaussianSpotNoise(spot, domain, 1).values;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  CHECK(gaussianSpotNoise(spot, domain, 1).values == many);
}
