// SPDX-License-Identifier: MIT
// Map (width * height * channels) -> its distance to a Gaussian, and whether that means anything.
// Surrogates with the exemplar's spectrum and random phases [GGM11] are Gaussian but for their
// finite number of pixels, and as correlated as the exemplar: a Monte Carlo test [B63].
#include "normality.h"

#include "color_space.h"
#include "gaussian_distribution.h"
#include "transport/random.h"

#include <lichen/spectrum.h>

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen::tiling {
namespace {

/// Rounding to 8 bits moves a value by at most half a step: what is nearer to a Gaussian than that
/// is one in the file. Beyond a whole step a value has another code, which may be seen, so that no
/// finite size of the exemplar excuses it (docs/decisions/011-gaussian-only.md).
constexpr double kInvisible = 0.5 / 255.0;
constexpr double kTolerated = 1.0 / 255.0;
/// Of the progress of a surrogate, a transform for each channel against a sort for each direction.
constexpr double kPhasesOfProgress = 0.3;
/// 8-bit normals have components in [-1, 1].
constexpr double kSlopeSpan = 2.0;

/// The exemplar's distance is the largest of 20 by chance in 5 % of Gaussian exemplars.
constexpr std::uint32_t kSurrogates = 19;

std::vector<ChannelVector> directionsFor(int channels) {
  // Even angles average what goes through up to seven periods in half a turn exactly. Sixteen
  // random directions are within 8 to 13 % (one deviation) of the distance over all, on six
  // photographs: little of the factor of two between the limits above. Any seed does.
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
  tbb::parallel_sort(projected.begin(), projected.end());
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

double distanceToGaussian(const std::vector<float>& values, int channels, ProgressPart progress) {
  const std::vector<ChannelVector> directions = directionsFor(channels);
  double sum = 0.0;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    progress.reach(double(k) / double(directions.size()));
    sum += squaredDistance(values, directions[k]);
  }
  return std::sqrt(sum / double(directions.size()));
}

/// The largest distance of Gaussian images with the map's size, spectra and cross-spectra.
double largestByChance(const MapExemplar& map, ProgressPart progress) {
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
    const ProgressPart part =
        progress.part(double(surrogate) / kSurrogates, double(surrogate + 1) / kSurrogates);
    for (std::size_t c = 0; c < channels; ++c) {
      part.reach(kPhasesOfProgress * double(c) / double(channels));
      const std::vector<float> plane = phaseRandomizedPlane(spectra[c], surrogate);
      for (std::size_t i = 0; i < plane.size(); ++i)
        values[i * channels + c] = plane[i];
    }
    largest = std::max(
        largest, distanceToGaussian(values, int(channels), part.part(kPhasesOfProgress, 1.0)));
  }
  return largest;
}

} // namespace

double distanceToGaussian(const MapExemplar& map, ProgressPart progress) {
  return distanceToGaussian(map.values, int(map.channels.size()), progress);
}

bool isGaussian(const MapExemplar& map, ProgressPart progress) {
  constexpr double kDistanceOfProgress = 1.0 / (1.0 + kSurrogates);
  const double span = map.encoding == ValueEncoding::slope ? kSlopeSpan : 1.0;
  const double distance = distanceToGaussian(map, progress.part(0.0, kDistanceOfProgress)) / span;
  if (distance <= kInvisible || distance > kTolerated)
    return distance <= kInvisible;
  return distance * span <= largestByChance(map, progress.part(kDistanceOfProgress, 1.0));
}

} // namespace lichen::tiling
