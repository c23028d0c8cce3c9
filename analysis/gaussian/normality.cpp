// SPDX-License-Identifier: MIT
// Map (width * height * channels) -> its distance to a Gaussian.
#include "normality.h"

#include "exemplar/color_space.h"
#include "gaussian_distribution.h"
#include "transport/random.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::gaussian {
namespace {

/// Rounding to 8 bits moves a value by at most half a step. Data closer to a Gaussian than that is
/// Gaussian in the file (docs/decisions/002-inverse-tables.md).
constexpr double kInvisible = 0.5 / 255.0;
/// 8-bit normals have components in [-1, 1].
constexpr double kSlopeSpan = 2.0;

std::vector<exemplar::ChannelVector> directionsFor(int channels) {
  // Evenly spaced angles average exactly whatever has up to seven periods in half a circle. For
  // sixteen random directions, the distance is within 8 to 13 % (one standard deviation) of that
  // over all directions, on six photographs. This is little compared with the factor of two between
  // the limits above. Any seed works.
  constexpr int kInPlane = 8;
  constexpr int kInSpace = 16;
  constexpr std::uint64_t kSeed = 11;
  std::vector<exemplar::ChannelVector> directions;
  if (channels == 1)
    directions.push_back(exemplar::ChannelVector::Ones(1));
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

/// Number of bins between a projection's smallest and largest value. A bin's values count as their
/// mean. The error is the covariance of values and deviates inside the bin: below 1e-6 of the
/// variance if the projection spans 16 standard deviations, or 0.001 of a standard deviation.
constexpr std::size_t kBins = 4096;

struct Bin {
  std::size_t count = 0;
  double sum = 0.0;
};

/// Returns the normal density at the quantile of `rank`, which is in (0, 1).
double densityAtRank(double rank) {
  const double deviate = (gaussianQuantile(rank) - kGaussianMean) / kGaussianDeviation;
  return std::exp(-0.5 * deviate * deviate) / std::sqrt(2.0 * std::numbers::pi);
}

/// Returns the mean product of the values, in order, and of normal deviates. The integral of the
/// deviates between the ranks of two bin borders is density(first) - density(last).
double productWithDeviates(const std::vector<Bin>& bins, double mean, std::size_t count) {
  double product = 0.0;
  double densityBelow = 0.0;
  std::size_t below = 0;
  for (const Bin& bin : bins) {
    if (bin.count == 0)
      continue;
    below += bin.count;
    const double density = below < count ? densityAtRank(double(below) / double(count)) : 0.0;
    product += (bin.sum / double(bin.count) - mean) * (densityBelow - density);
    densityBelow = density;
  }
  return product;
}

/// Returns the squared distance of one projection. For x and normal deviates z in the same order,
/// E[(x - mean - deviation z)^2] = 2 variance - 2 deviation E[(x - mean) z].
double squaredDistance(const std::vector<float>& values, const exemplar::Moments& moments,
                       const exemplar::ChannelVector& direction) {
  const auto channels = std::size_t(direction.size());
  std::vector<float> projected(values.size() / channels);
  for (std::size_t i = 0; i < projected.size(); ++i) {
    double sum = 0.0;
    for (std::size_t c = 0; c < channels; ++c)
      sum += direction[Eigen::Index(c)] * double(values[i * channels + c]);
    projected[i] = float(sum);
  }
  const auto [least, largest] = std::minmax_element(projected.begin(), projected.end());
  const double span = double(*largest) - double(*least);
  const double binsPerUnit = span > 0.0 ? double(kBins) / span : 0.0;
  std::vector<Bin> bins(kBins);
  for (const float value : projected) {
    const auto place = std::size_t((double(value) - double(*least)) * binsPerUnit);
    Bin& bin = bins[std::min(place, kBins - 1)];
    ++bin.count;
    bin.sum += double(value);
  }
  const double variance = direction.dot(moments.covariance * direction);
  const double product = productWithDeviates(bins, direction.dot(moments.mean), projected.size());
  return std::max(0.0, 2.0 * variance - 2.0 * std::sqrt(variance) * product);
}

double distanceToGaussian(const std::vector<float>& values, int channels) {
  const std::vector<exemplar::ChannelVector> directions = directionsFor(channels);
  const exemplar::Moments moments = exemplar::momentsOf(values, channels);
  std::vector<double> squares(directions.size());
  tbb::parallel_for(std::size_t(0), directions.size(), [&](std::size_t k) {
    squares[k] = squaredDistance(values, moments, directions[k]);
  });
  double sum = 0.0;
  for (const double square : squares)
    sum += square;
  return std::sqrt(sum / double(squares.size()));
}

} // namespace

double distanceToGaussian(const MapExemplar& map) {
  return distanceToGaussian(map.values, int(map.channels.size()));
}

bool isGaussian(const MapExemplar& map) {
  const double span = map.encoding == ValueEncoding::slope ? kSlopeSpan : 1.0;
  return distanceToGaussian(map) <= kInvisible * span;
}

} // namespace lichen::gaussian
