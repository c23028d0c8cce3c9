// SPDX-License-Identifier: MIT
#include <lichen/fft.h>
#include <lichen/lattice.h>
#include <lichen/spectrum.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

using namespace lichen;

namespace {

/// Uniform white noise of variance 1/12.
std::vector<float> whiteNoise(int width, int height, std::uint32_t seed) {
  std::vector<float> plane;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      plane.push_back(float(pcg3d({std::uint32_t(x), std::uint32_t(y), seed})[0]) * 0x1p-32f);
  return plane;
}

} // namespace

TEST_CASE("luminance weights the colours and ignores alpha") {
  SrgbImage image(1, 1, 4);
  image.values = {0.5f, 0.25f, 1.0f, 0.1f};
  CHECK(luminancePlane(image)[0] == Approx(0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722));
  SrgbImage grey(1, 1, 2);
  grey.values = {0.75f, 0.0f};
  CHECK(luminancePlane(grey)[0] == 0.75f);
}

TEST_CASE("the radial power of white noise is its variance at every frequency") {
  constexpr int kSide = 1024, kCrop = 64;
  const std::vector<double> power =
      radialPowerSpectrum(whiteNoise(kSide, kSide, 1), kSide, kSide, kCrop);
  REQUIRE(power.size() == kCrop / 2 + 1);
  // Ring 4 holds 24 frequencies (12 independent), and 961 overlapping crops count as about 550: a
  // relative standard deviation of 1.2 %. The tolerance is 4 of these, alpha 6e-5 per ring and less
  // for larger rings. Rings 0 and 1 lack the power of the subtracted mean.
  for (std::size_t ring = 4; ring < power.size(); ++ring)
    CHECK(power[ring] == Approx(1.0 / 12.0).epsilon(0.05));
}

TEST_CASE("a cosine's power is in its own ring and, through the window, the next ones") {
  constexpr int kWidth = 256, kHeight = 192, kCrop = 64, kCycles = 10;
  constexpr double kAmplitude = 0.1;
  int ringSize = 0;
  for (int v = 1 - kCrop / 2; v <= kCrop / 2; ++v)
    for (int u = 1 - kCrop / 2; u <= kCrop / 2; ++u)
      ringSize += std::lround(std::hypot(u, v)) == kCycles ? 1 : 0;
  // Two lines of (amplitude / 2)^2 (sum w)^2. Beside each, in the same ring, are two lines of a
  // quarter of it, because the Hann window has 1/2 at 0 and 1/4 at +-1 cycles. sum w^2 is 3/8 per
  // pixel.
  const double line = std::pow(0.5 * kAmplitude * kCrop * kCrop / 4.0, 2.0);
  const double expected = 2.0 * 1.5 * line / std::pow(3.0 / 8.0 * kCrop, 2.0) / ringSize;
  for (const bool alongX : {true, false}) {
    std::vector<float> plane;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        plane.push_back(float(0.5 + kAmplitude * std::cos(2.0 * std::numbers::pi * kCycles *
                                                          (alongX ? x : y) / kCrop)));
    const std::vector<double> power = radialPowerSpectrum(plane, kWidth, kHeight, kCrop);
    CHECK(power[kCycles] == Approx(expected).epsilon(1e-3));
    for (std::size_t ring = 0; ring < power.size(); ++ring) {
      if (ring < kCycles - 1 || ring > kCycles + 1)
        CHECK(power[ring] < 1e-6 * power[kCycles]);
    }
  }
}

TEST_CASE("autocovariance agrees with the sum over pairs") {
  constexpr int kWidth = 19, kHeight = 14, kSupport = 5;
  const std::vector<float> plane = whiteNoise(kWidth, kHeight, 2);
  double mean = 0.0;
  for (const float value : plane)
    mean += double(value) / double(plane.size());
  const std::vector<double> covariance = autocovariance(plane, kWidth, kHeight, kSupport);
  REQUIRE(covariance.size() == 81);
  std::size_t lag = 0;
  for (int dy = 1 - kSupport; dy < kSupport; ++dy) {
    for (int dx = 1 - kSupport; dx < kSupport; ++dx) {
      double sum = 0.0;
      int pairs = 0;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          if (x + dx < 0 || x + dx >= kWidth || y + dy < 0 || y + dy >= kHeight)
            continue;
          sum += (double(plane[std::size_t(y * kWidth + x)]) - mean) *
                 (double(plane[std::size_t((y + dy) * kWidth + x + dx)]) - mean);
          ++pairs;
        }
      }
      CHECK(covariance[lag++] == Approx(sum / pairs).margin(1e-7));
    }
  }
}

TEST_CASE("the cross-spectrum is the transform of the wrapped covariances of two planes") {
  for (const auto& [width, height] : {std::pair{12, 7}, std::pair{5, 8}, std::pair{1, 3}}) {
    const std::vector<float> a = whiteNoise(width, height, 5);
    const std::vector<float> b = whiteNoise(width, height, 6);
    const HalfSpectrum spectrumA = forwardFft(a, width, height);
    const std::vector<float> covariance =
        inverseFft(crossSpectrum(spectrumA, forwardFft(b, width, height)));
    for (int dy = 0; dy < height; ++dy) {
      for (int dx = 0; dx < width; ++dx) {
        double sum = 0.0;
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x)
            sum += double(a[std::size_t(y * width + x)]) *
                   double(b[std::size_t((y + dy) % height * width + (x + dx) % width)]);
        CHECK(covariance[std::size_t(dy * width + dx)] ==
              Approx(sum / (width * height)).margin(1e-6));
      }
    }
    const HalfSpectrum self = crossSpectrum(spectrumA, spectrumA);
    const std::vector<float> power = powerSpectrum(spectrumA);
    REQUIRE(power.size() == self.values.size());
    for (std::size_t i = 0; i < power.size(); ++i) {
      CHECK(self.values[i].real() == Approx(power[i]));
      CHECK(self.values[i].imag() == Approx(0.0f).margin(1e-6));
    }
  }
}

TEST_CASE("the power of white noise is its variance on average") {
  constexpr int kSide = 128;
  const std::vector<float> power =
      powerSpectrum(forwardFft(whiteNoise(kSide, kSide, 7), kSide, kSide));
  double mean = 0.0; // without the columns that are their own mirror: each value counts once
  constexpr int kColumns = kSide / 2 - 1;
  for (int v = 0; v < kSide; ++v)
    for (int u = 1; u <= kColumns; ++u)
      mean += double(power[std::size_t(v * (kSide / 2 + 1) + u)]) / (kSide * kColumns);
  // Exponential variates: 4.5 standard deviations of their mean, one false alarm in 150,000.
  CHECK(mean == Approx(1.0 / 12.0).epsilon(4.5 / std::sqrt(double(kSide * kColumns))));
}

TEST_CASE(
    "the Laplacian of the smooth component is the jumps across the borders, and its mean is 0") {
  // [M11] eq. 9, which determines the periodic component.
  for (const auto& [width, height] :
       {std::pair{16, 12}, std::pair{13, 7}, std::pair{1, 9}, std::pair{8, 1}, std::pair{1, 1}}) {
    const std::vector<float> plane = whiteNoise(width, height, 4);
    const std::vector<float> periodic = periodicComponent(plane, width, height);
    const auto at = [columns = width](int x, int y) { return std::size_t(y * columns + x); };
    const auto smooth = [&](int x, int y) {
      const std::size_t i = at((x + width) % width, (y + height) % height);
      return double(plane[i]) - double(periodic[i]);
    };
    double sum = 0.0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        double jumps = 0.0;
        if (x == 0)
          jumps += double(plane[at(width - 1, y)]) - double(plane[at(0, y)]);
        if (x == width - 1)
          jumps += double(plane[at(0, y)]) - double(plane[at(width - 1, y)]);
        if (y == 0)
          jumps += double(plane[at(x, height - 1)]) - double(plane[at(x, 0)]);
        if (y == height - 1)
          jumps += double(plane[at(x, 0)]) - double(plane[at(x, height - 1)]);
        const double laplacian = smooth(x - 1, y) + smooth(x + 1, y) + smooth(x, y - 1) +
                                 smooth(x, y + 1) - 4.0 * smooth(x, y);
        CHECK(laplacian == Approx(jumps).margin(1e-5));
        sum += smooth(x, y);
      }
    }
    CHECK(std::abs(sum) < 1e-5);
  }
}
