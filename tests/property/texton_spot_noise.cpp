// SPDX-License-Identifier: MIT
// Spot noises and their Gaussian limit, against closed forms.
//
// The statistics are means over independent tori. Each must be within 4.5 of its estimated standard
// errors from the expected value: one false alarm in 150,000 each. The seeds are fixed.
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

/// 0 outside the spot.
double at(const Spot& spot, int x, int y, int channel) {
  if (x < 0 || y < 0 || x >= spot.width || y >= spot.height)
    return 0.0;
  return double(spot.values[std::size_t((channel * spot.height + y) * spot.width + x)]);
}

/// sum over y of h_c(y) h_d(y + lag)
double spotCovariance(const Spot& spot, int c, int d, int lagX, int lagY) {
  double sum = 0.0;
  for (int y = 0; y < spot.height; ++y)
    for (int x = 0; x < spot.width; ++x)
      sum += at(spot, x, y, c) * at(spot, x + lagX, y + lagY, d);
  return sum;
}

double spotPower(const Spot& spot, int exponent) {
  double sum = 0.0;
  for (int y = 0; y < spot.height; ++y)
    for (int x = 0; x < spot.width; ++x)
      sum += std::pow(at(spot, x, y, 0), exponent);
  return sum;
}

double largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(double(a[i]) - double(b[i])));
  return largest;
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

/// The mean over a torus of f(x, y).
template <class F>
double torusMean(const NoisePlanes& noise, const F& f) {
  double sum = 0.0;
  for (int y = 0; y < noise.height; ++y)
    for (int x = 0; x < noise.width; ++x)
      sum += f(x, y);
  return sum / noise.width / noise.height;
}

constexpr std::array<std::pair<int, int>, 5> kLags{{{0, 0}, {1, 0}, {-2, 1}, {0, 3}, {2, 3}}};

/// Mean, covariances at kLags, and third and fourth moments of `noise(seed)` on tori, against those
/// of the spot. `rarity` is 1 / intensity.
template <class Noise>
void checkMoments(const Spot& spot, double rarity, const Noise& noise) {
  constexpr int kTori = 2000;
  Sample mean, third, fourth;
  std::array<Sample, kLags.size() * 4> covariances;
  for (int seed = 0; seed < kTori; ++seed) {
    const NoisePlanes torus = noise(std::uint64_t(seed));
    const auto power = [&](int exponent) {
      return torusMean(
          torus, [&](int x, int y) { return std::pow(double(at(torus, x, y, 0)), exponent); });
    };
    mean.add(power(1));
    third.add(power(3));
    fourth.add(power(4));
    for (std::size_t k = 0; k < covariances.size(); ++k) {
      const auto [lagX, lagY] = kLags[k / 4];
      covariances[k].add(torusMean(torus, [&, dx = lagX, dy = lagY](int x, int y) {
        return double(at(torus, x, y, int(k / 2 % 2))) *
               double(at(torus, (x + dx + torus.width) % torus.width,
                         (y + dy + torus.height) % torus.height, int(k % 2)));
      }));
    }
  }
  // Campbell's theorem: the n-th cumulant is sum h^n / intensity^(n / 2 - 1).
  mean.checkMean(0.0);
  third.checkMean(spotPower(spot, 3) * std::sqrt(rarity));
  const double variance = spotPower(spot, 2);
  fourth.checkMean(3.0 * variance * variance + spotPower(spot, 4) * rarity);
  for (std::size_t k = 0; k < covariances.size(); ++k) {
    INFO("lag " << k / 4 << ", channels " << k / 2 % 2 << " and " << k % 2);
    const auto [lagX, lagY] = kLags[k / 4];
    covariances[k].checkMean(spotCovariance(spot, int(k / 2 % 2), int(k % 2), lagX, lagY));
  }
}

GaussianModel modelOf(const MapExemplar& map) {
  return gaussianModel(map.values, map.width, map.height, int(map.channels.size()));
}

} // namespace

TEST_CASE("counts of points follow the Poisson distribution, for small and large means") {
  constexpr int kSide = 256;
  for (const double mean : {0.03, 0.7, 5.0, 32.0, 33.0, 200.0}) {
    const std::vector<float> counts = poissonCounts({-7, 90, kSide, kSide, false}, mean, 3);
    std::vector<double> observed(std::size_t(2.0 * mean) + 40, 0.0);
    for (const float count : counts) {
      REQUIRE(std::size_t(count) < observed.size());
      ++observed[std::size_t(count)];
    }
    // Pearson's test; each class expects at least 10, and the remainder joins the last class.
    double chiSquare = 0.0, expected = 0.0, found = 0.0, left = double(counts.size());
    int classes = 0;
    const auto closeClass = [&] {
      chiSquare += (found - expected) * (found - expected) / expected;
      ++classes;
      expected = found = 0.0;
    };
    for (std::size_t k = 0; k < observed.size(); ++k) {
      const double share = std::exp(double(k) * std::log(mean) - mean - std::lgamma(double(k) + 1));
      expected += share * double(counts.size());
      left -= share * double(counts.size());
      found += observed[k];
      if (expected >= 10.0 && left >= 10.0)
        closeClass();
    }
    expected += left;
    closeClass();
    // [WH31]; 4.26 standard deviations: one false alarm in 100,000.
    const double freedom = classes - 1;
    const double limit =
        freedom *
        std::pow(1.0 - 2.0 / (9.0 * freedom) + 4.26 * std::sqrt(2.0 / (9.0 * freedom)), 3.0);
    INFO("mean " << mean << ", " << classes << " classes");
    CHECK(chiSquare < limit);
  }
}

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

TEST_CASE("direct and Fourier summation give the same noise, on planes and tori") {
  const Spot spot = skewedSpot(7, 4);
  for (const bool periodic : {false, true}) {
    // Odd, prime, smaller than the spot, one pixel; far from the origin.
    for (const PixelDomain& domain :
         {PixelDomain{0, 0, 24, 18, periodic}, PixelDomain{-1000, 777, 31, 29, periodic},
          PixelDomain{5, -3, 5, 3, periodic}, PixelDomain{0, 0, 1, 1, periodic}}) {
      for (const double intensity : {0.02, 3.0}) {
        const NoisePlanes direct = discreteSpotNoise(spot, intensity, domain, 4, Summation::direct);
        const NoisePlanes spectral =
            discreteSpotNoise(spot, intensity, domain, 4, Summation::spectral);
        CHECK(largestDifference(direct.values, spectral.values) < kRounding);
      }
    }
  }
}

TEST_CASE("a crop of a noise is the noise of the crop") {
  const Spot spot = skewedSpot(5, 6);
  const NoisePlanes whole =
      discreteSpotNoise(spot, 0.1, {-9, 4, 40, 30, false}, 6, Summation::direct);
  const NoisePlanes part =
      discreteSpotNoise(spot, 0.1, {3, 10, 11, 13, false}, 6, Summation::direct);
  for (int c = 0; c < 2; ++c)
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        CHECK(at(part, x, y, c) == at(whole, x + 3 + 9, y + 10 - 4, c));
}

TEST_CASE("a crop of a circular noise equals the plane's only if the margin contains the spot") {
  const Spot spot = skewedSpot(5, 6);
  const PixelDomain plane{2, 3, 30, 26, false};
  PixelDomain torus = plane;
  torus.periodic = true;
  const auto agree = [&](const NoisePlanes& a, const NoisePlanes& b) {
    int inside = 0, outside = 0;
    for (int c = 0; c < 2; ++c) {
      for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
          const bool same = std::abs(double(at(a, x, y, c)) - double(at(b, x, y, c))) < kRounding;
          if (x >= spot.width - 1 && y >= spot.height - 1)
            inside += same ? 0 : 1;
          else
            outside += same ? 0 : 1;
        }
      }
    }
    CHECK(inside == 0);
    CHECK(outside > 0);
  };
  agree(discreteSpotNoise(spot, 0.2, torus, 8, Summation::direct),
        discreteSpotNoise(spot, 0.2, plane, 8, Summation::direct));
  agree(gaussianSpotNoise(spot, torus, 8), gaussianSpotNoise(spot, plane, 8));
}

TEST_CASE("a spot noise has the mean, covariances and cumulants of its spot") {
  const Spot spot = skewedSpot(3, 4);
  for (const double intensity : {0.1, 2.0}) {
    INFO("intensity " << intensity);
    checkMoments(spot, 1.0 / intensity, [&](std::uint64_t seed) {
      return discreteSpotNoise(spot, intensity, {0, 0, 12, 10, true}, seed, Summation::direct);
    });
  }
}

TEST_CASE(
    "the Gaussian limit of spot noise has the covariances of the spot and no higher cumulant") {
  const Spot spot = skewedSpot(3, 4);
  checkMoments(spot, 0.0, [&](std::uint64_t seed) {
    return gaussianSpotNoise(spot, {0, 0, 12, 10, true}, seed);
  });
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
  const auto noises = [&] {
    return std::array{discreteSpotNoise(spot, 0.3, domain, 1, Summation::direct).values,
                      discreteSpotNoise(spot, 0.3, domain, 1, Summation::spectral).values,
                      gaussianSpotNoise(spot, domain, 1).values};
  };
  const auto many = noises();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  CHECK(noises() == many);
}
