// SPDX-License-Identifier: MIT
// What [LRP14] does with a structure, beside what is done here: blocks of few cosines (section 5.3)
// beside an image, and a blend with the gain of the tiles' correlation beside one about their mean.
#include <lichen/fft.h>
#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <local_random_phase/octave_lattice.h>
#include <placement/near_periods.h>
#include <random>

using namespace lichen;
using namespace lichen::local_random_phase;

namespace {

constexpr int kSide = 128;
using Plane = std::vector<double>;

double at(const Plane& plane, int x, int y) {
  return plane[std::size_t((y + 4 * kSide) % kSide * kSide + (x + 4 * kSide) % kSide)];
}

Plane normalized(Plane plane) {
  double mean = 0.0, squares = 0.0;
  for (const double value : plane)
    mean += value / double(plane.size());
  for (const double value : plane)
    squares += (value - mean) * (value - mean) / double(plane.size());
  for (double& value : plane)
    value = (value - mean) / std::sqrt(squares);
  return plane;
}

/// Bricks of 32 x 16 pixels in a running bond, each of its own shade; mean 0, deviation 1.
Plane bricks() {
  std::mt19937 generator(9u);
  std::normal_distribution<double> normal;
  Plane plane(kSide * kSide);
  std::array<double, 32> shades{};
  for (double& shade : shades)
    shade = 0.4 * normal(generator);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const int row = y / 16, left = (x + 16 * (row % 2)) % kSide;
      const bool isMortar = y % 16 < 3 || left % 32 < 3;
      plane[std::size_t(y) * kSide + std::size_t(x)] =
          (isMortar ? 2.0 : shades[std::size_t(4 * row) + std::size_t(left / 32)]) +
          0.2 * normal(generator);
    }
  return normalized(std::move(plane));
}

HalfSpectrum transformOf(const Plane& plane, int side) {
  return forwardFft(std::vector<float>(plane.begin(), plane.end()), side, side);
}

/// The plane of the `count` strongest frequencies of a square, and its mean.
Plane strongest(const Plane& plane, int side, std::size_t count) {
  HalfSpectrum spectrum = transformOf(plane, side);
  std::vector<float> powers;
  for (std::size_t i = 1; i < spectrum.values.size(); ++i)
    powers.push_back(std::norm(spectrum.values[i]));
  std::nth_element(powers.begin(), powers.begin() + std::ptrdiff_t(count) - 1, powers.end(),
                   std::greater<>());
  for (std::size_t i = 1; i < spectrum.values.size(); ++i)
    if (std::norm(spectrum.values[i]) < powers[count - 1])
      spectrum.values[i] = 0.0f;
  const std::vector<float> kept = inverseFft(spectrum);
  return {kept.begin(), kept.end()};
}

/// The deviation of the difference of a plane from its blocks with 15 cosines each, over its own.
double blockError(const Plane& plane, int block) {
  constexpr std::size_t kCosines = 15;
  double squares = 0.0, errors = 0.0;
  for (int top = 0; top < kSide; top += block)
    for (int left = 0; left < kSide; left += block) {
      Plane own;
      for (int y = 0; y < block; ++y)
        for (int x = 0; x < block; ++x)
          own.push_back(at(plane, left + x, top + y));
      const Plane kept = strongest(own, block, kCosines);
      for (std::size_t i = 0; i < own.size(); ++i) {
        squares += own[i] * own[i];
        errors += (kept[i] - own[i]) * (kept[i] - own[i]);
      }
    }
  return std::sqrt(errors / squares);
}

/// The autocovariance of a periodic plane at lags of up to 20 pixels.
std::vector<double> covarianceOf(const Plane& plane) {
  std::vector<double> result;
  for (int v = 0; v <= 20; ++v)
    for (int u = 0; u <= 20; ++u) {
      double sum = 0.0;
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
          sum += at(plane, x, y) * at(plane, x + u, y + v);
      result.push_back(sum / (kSide * kSide));
    }
  return result;
}

} // namespace

TEST_CASE(
    "[LRP14] section 5.3: a block of few cosines is not the structure unless it holds about as "
    "many numbers as texels") {
  // Structure with the proportion 0.3 to 0.7 of the energy: so many of the strongest frequencies.
  for (const std::size_t frequencies : {40u, 200u, 800u}) {
    const Plane structure = strongest(bricks(), kSide, frequencies);
    INFO(frequencies << " frequencies");
    // The paper wants 1/256. A cosine has a frequency, an amplitude and a phase: 45 numbers in a
    // block of 256, 64 or 16 texels.
    CHECK(blockError(structure, 16) > 10.0 / 256.0);
    CHECK(blockError(structure, 8) > 1.0 / 256.0);
    CHECK(blockError(structure, 8) < blockError(structure, 16));
  }
}

TEST_CASE("a blend about the mean over the list keeps what repeats, and the gain of the tiles' "
          "correlation does not") {
  const Plane exemplar = bricks();
  MapExemplar map;
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  map.encoding = ValueEncoding::linear;
  map.width = map.height = kSide;
  map.values.assign(exemplar.begin(), exemplar.end());
  const placement::NearPeriods periods = placement::nearPeriods({&map, 1}, 64);
  REQUIRE(periods.shifts.size() >= 16);
  std::vector<std::array<int, 2>> shifts;
  for (const std::array<double, 2>& shift : periods.shifts)
    shifts.push_back({int(std::lround(shift[0] * kSide)), int(std::lround(shift[1] * kSide))});
  const HalfSpectrum transform = transformOf(exemplar, kSide);
  HalfSpectrum power = transform;
  for (std::complex<float>& value : power.values)
    value = std::norm(value) / float(kSide * kSide);
  const std::vector<float> correlation = inverseFft(power);
  const auto rho = [&](const std::array<int, 2>& a, const std::array<int, 2>& b) {
    const int x = (a[0] - b[0] + 2 * kSide) % kSide, y = (a[1] - b[1] + 2 * kSide) % kSide;
    return double(correlation[std::size_t(y) * kSide + std::size_t(x)]);
  };
  Plane mean(exemplar.size());
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (const std::array<int, 2>& shift : shifts)
        mean[std::size_t(y * kSide + x)] +=
            at(exemplar, x + shift[0], y + shift[1]) / double(shifts.size());
  // Vertices a quarter of the side apart, in a lattice that repeats with the plane.
  const auto blended = [&](bool isAboutMean, std::uint32_t seed) {
    Plane result;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const double row = 4.0 * (y + 0.5) / kSide, column = 4.0 * (x + 0.5) / kSide - 0.5 * row;
        const int i = int(std::floor(column)), j = int(std::floor(row));
        const auto windows = windowsAt(column - i, row - j);
        std::array<std::array<int, 2>, 3> own{};
        double blend = 0.0, sum = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          int vi = i + windows.corner[k][0], vj = j + windows.corner[k][1];
          if (vj >= 4) {
            vj -= 4;
            vi += 2;
          }
          vi = (vi + 8) % 4;
          own[k] = shifts[vertexHash(std::uint32_t(vi), std::uint32_t(vj), seed) % shifts.size()];
          blend += windows.weight[k] * at(exemplar, x + own[k][0], y + own[k][1]);
          sum += windows.weight[k];
        }
        if (isAboutMean) {
          result.push_back(blend + (1.0 - sum) * at(mean, x, y));
          continue;
        }
        double variance = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t l = 0; l < 3; ++l)
            variance += windows.weight[k] * windows.weight[l] * rho(own[k], own[l]);
        result.push_back(blend / std::sqrt(variance));
      }
    return result;
  };
  const std::vector<double> wanted = covarianceOf(exemplar);
  const auto errorOf = [&](bool isAboutMean) {
    std::vector<double> found(wanted.size());
    constexpr std::uint32_t kSeeds = 6;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      const std::vector<double> own = covarianceOf(normalized(blended(isAboutMean, seed)));
      for (std::size_t k = 0; k < own.size(); ++k)
        found[k] += own[k] / kSeeds;
    }
    double errors = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      errors += std::pow(found[k] - wanted[k], 2.0);
      squares += wanted[k] * wanted[k];
    }
    return std::sqrt(errors / squares);
  };
  const double aboutMean = errorOf(true), withGain = errorOf(false);
  INFO("about the mean " << aboutMean << ", with the gain " << withGain);
  CHECK(aboutMean < 0.15);
  CHECK(aboutMean < 0.7 * withGain);
}
