// SPDX-License-Identifier: MIT
// Map (width * height * channels) -> its distance to a Gaussian, and whether that means anything.
// Surrogates with the exemplar's spectrum and random phases [GGM11] are Gaussian but for their
// finite number of pixels, and as correlated as the exemplar: a Monte Carlo test [B63].
#include "normality.h"

#include "color_space.h"
#include "gaussian_distribution.h"
#include "transport/random.h"

#include <lichen/spectrum.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen::tiling {
namespace {

/// A distance that rounding to 8 bits hides, and one that a finite exemplar is forgiven.
constexpr double kInvisible = 0.5 / 255.0;
constexpr double kTolerated = 1.0 / 255.0;
/// 8-bit normals have components in [-1, 1].
constexpr double kSlopeSpan = 2.0;

/// The exemplar's distance is the largest of 20 by chance in 5 % of Gaussian exemplars.
constexpr std::uint32_t kSurrogates = 19;

std::vector<ChannelVector> directionsFor(int channels) {
  constexpr int kInPlane = 8;
  constexpr int kInSpace = 16;
  constexpr std::uint64_t kSeed = 11;
  std::vector<ChannelVector> directions;
  if (channels == 1)
    directions.push_back(ChannelVector::Ones(1));
  for (int k = 0; channels == 2 && k < kInPlane; ++k) {
    const double angle = std::numbers::pi * k / kInPlane;
    directions.push_back(Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  for (std::uint64_t k = 0; channels == 3 && k < kInSpace; ++k) {
    const Point d = transport::randomDirection(kSeed, k);
    directions.push_back(Eigen::Vector3d(double(d.x), double(d.y), double(d.z)));
  }
  return directions;
}

/// The squared distance of one projection.
double squaredDistance(const std::vector<float>& values, const ChannelVector& direction) {
  const auto channels = std::size_t(direction.size());
  std::vector<float> projected(values.size() / channels);
  for (std::size_t i = 0; i < projected.size(); ++i) {
    double sum = 0.0;
    for (std::size_t c = 0; c < channels; ++c)
      sum += direction[Eigen::Index(c)] * double(values[i * channels + c]);
    projected[i] = float(sum);
  }
  std::sort(projected.begin(), projected.end());
  const Moments moments = momentsOf(projected, 1);
  const double deviation = std::sqrt(moments.covariance(0, 0));
  const auto count = double(projected.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < projected.size(); ++i) {
    const double deviate =
        (gaussianQuantile((double(i) + 0.5) / count) - kGaussianMean) / kGaussianDeviation;
    const double difference = double(projected[i]) - moments.mean[0] - deviation * deviate;
    squares += difference * difference / count;
  }
  return squares;
}

double distanceToGaussian(const std::vector<float>& values, int channels) {
  const std::vector<ChannelVector> directions = directionsFor(channels);
  std::vector<double> squares(directions.size());
  tbb::parallel_for(std::size_t(0), directions.size(),
                    [&](std::size_t k) { squares[k] = squaredDistance(values, directions[k]); });
  double sum = 0.0;
  for (const double square : squares)
    sum += square;
  return std::sqrt(sum / double(squares.size()));
}

/// The largest distance of Gaussian images with the map's size, spectra and cross-spectra.
double largestByChance(const MapExemplar& map) {
  const std::size_t channels = map.channels.size();
  std::vector<HalfSpectrum> spectra;
  for (std::size_t c = 0; c < channels; ++c) {
    std::vector<float> plane;
    for (std::size_t i = c; i < map.values.size(); i += channels)
      plane.push_back(map.values[i]);
    spectra.push_back(forwardFft(plane, map.width, map.height));
  }
  double largest = 0.0;
  std::vector<float> values(map.values.size());
  for (std::uint32_t surrogate = 0; surrogate < kSurrogates; ++surrogate) {
    for (std::size_t c = 0; c < channels; ++c) {
      const std::vector<float> plane = phaseRandomizedPlane(spectra[c], surrogate);
      for (std::size_t i = 0; i < plane.size(); ++i)
        values[i * channels + c] = plane[i];
    }
    largest = std::max(largest, distanceToGaussian(values, int(channels)));
  }
  return largest;
}

} // namespace

double distanceToGaussian(const MapExemplar& map) {
  return distanceToGaussian(map.values, int(map.channels.size()));
}

bool isGaussian(const MapExemplar& map) {
  const double span = map.encoding == ValueEncoding::slope ? kSlopeSpan : 1.0;
  const double distance = distanceToGaussian(map) / span;
  if (distance <= kInvisible || distance > kTolerated)
    return distance <= kInvisible;
  return distance * span <= largestByChance(map);
}

} // namespace lichen::tiling
