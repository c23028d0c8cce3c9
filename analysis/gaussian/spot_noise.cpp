// SPDX-License-Identifier: MIT
// Spot (channels, height, width) and domain -> noise on the domain (channels, height, width).
//
// [GLM14] algorithm 1 draws the number of points on the domain and then their positions. This code
// draws the number on each pixel instead. The law is the same, because counts of a Poisson process
// on disjoint sets are independent. The noise is then one process on Z^2, and any part of it is
// available "on demand", as section 2.4 asks.
#include "spot_noise.h"

#include <lichen/fft.h>

#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace lichen::gaussian {
namespace {

/// Returns the domain of points whose spots reach `domain`, [GLM14] algorithm 1: `domain` minus the
/// spot's pixels. On a torus this is the torus.
PixelDomain pointDomain(const PixelDomain& domain, const Spot& spot) {
  if (domain.periodic)
    return domain;
  return {domain.x - (spot.width - 1), domain.y - (spot.height - 1), domain.width + spot.width - 1,
          domain.height + spot.height - 1, false};
}

std::span<const float> plane(const Spot& spot, int channel) {
  const std::size_t pixels = std::size_t(spot.width) * std::size_t(spot.height);
  return std::span(spot.values).subspan(std::size_t(channel) * pixels, pixels);
}

std::span<float> plane(NoisePlanes& noise, int channel) {
  const std::size_t pixels = std::size_t(noise.width) * std::size_t(noise.height);
  return std::span(noise.values).subspan(std::size_t(channel) * pixels, pixels);
}

NoisePlanes zeros(const PixelDomain& domain, int channels) {
  NoisePlanes noise{domain.width, domain.height, channels, {}};
  noise.values.assign(
      std::size_t(channels) * std::size_t(domain.width) * std::size_t(domain.height), 0.0f);
  return noise;
}

/// The points on one row of the point domain: column and count.
using PointRow = std::vector<std::pair<int, float>>;

std::vector<PointRow> pointRows(const PixelDomain& points, const std::vector<float>& counts) {
  std::vector<PointRow> rows(std::size_t(points.height));
  for (int y = 0; y < points.height; ++y) {
    for (int x = 0; x < points.width; ++x) {
      const float count = counts[std::size_t(y) * std::size_t(points.width) + std::size_t(x)];
      if (count > 0.0f)
        rows[std::size_t(y)].emplace_back(x, count);
    }
  }
  return rows;
}

/// Adds the contribution of row `j` of the spot, from one row of points, to a row of noise.
void addSpotRow(std::span<const float> spotRow, const PointRow& points, bool periodic,
                std::span<float> row) {
  const int width = int(row.size());
  const int spotWidth = int(spotRow.size());
  for (const auto& [column, count] : points) {
    if (periodic) {
      for (int i = 0; i < spotWidth; ++i)
        row[std::size_t((column + i) % width)] += count * spotRow[std::size_t(i)];
      continue;
    }
    const int first = column - (spotWidth - 1); // in columns of the noise
    const int begin = std::max(0, -first);
    const int end = std::min(spotWidth, width - first);
    for (int i = begin; i < end; ++i)
      row[std::size_t(first + i)] += count * spotRow[std::size_t(i)];
  }
}

/// Sums over all points. One thread writes each row of the noise.
NoisePlanes summedDirectly(const Spot& spot, const std::vector<PointRow>& points,
                           const PixelDomain& domain) {
  NoisePlanes noise = zeros(domain, spot.channels);
  const auto columns = std::size_t(domain.width);
  const auto spotColumns = std::size_t(spot.width);
  for (int c = 0; c < spot.channels; ++c) {
    const std::span<float> to = plane(noise, c);
    const std::span<const float> from = plane(spot, c);
    tbb::parallel_for(0, domain.height, [&](int y) {
      for (int j = 0; j < spot.height; ++j) {
        const int pointY = domain.periodic
                               ? ((y - j) % domain.height + domain.height) % domain.height
                               : y - j + spot.height - 1;
        addSpotRow(from.subspan(std::size_t(j) * spotColumns, spotColumns),
                   points[std::size_t(pointY)], domain.periodic,
                   to.subspan(std::size_t(y) * columns, columns));
      }
    });
  }
  return noise;
}

/// Convolves the spot with a field on its point domain. The transforms are periodic. On a plane of
/// the field's size, the part that wraps falls on pixels outside the domain.
NoisePlanes convolvedBySpectra(const Spot& spot, const std::vector<float>& field,
                               const PixelDomain& points, const PixelDomain& domain) {
  const int width = domain.periodic ? domain.width : fastTransformSize(points.width);
  const int height = domain.periodic ? domain.height : fastTransformSize(points.height);
  const auto at = [columns = std::size_t(width)](int x, int y) {
    return std::size_t(y) * columns + std::size_t(x);
  };
  std::vector<float> padded(std::size_t(width) * std::size_t(height), 0.0f);
  for (int y = 0; y < points.height; ++y)
    std::copy_n(field.data() + std::ptrdiff_t(y) * points.width, points.width,
                padded.data() + std::ptrdiff_t(y) * width);
  const HalfSpectrum fieldSpectrum = forwardFft(padded, width, height);

  const int left = domain.x - points.x;
  const int top = domain.y - points.y;
  NoisePlanes noise = zeros(domain, spot.channels);
  for (int c = 0; c < spot.channels; ++c) {
    padded.assign(padded.size(), 0.0f);
    const std::span<const float> from = plane(spot, c);
    for (int j = 0; j < spot.height; ++j)
      for (int i = 0; i < spot.width; ++i)
        padded[at(i % width, j % height)] +=
            from[std::size_t(j) * std::size_t(spot.width) + std::size_t(i)];
    HalfSpectrum product = forwardFft(padded, width, height);
    for (std::size_t i = 0; i < product.values.size(); ++i)
      product.values[i] *= fieldSpectrum.values[i];
    const std::vector<float> convolved = inverseFft(product);
    const std::span<float> to = plane(noise, c);
    for (int y = 0; y < domain.height; ++y)
      std::copy_n(convolved.data() + at(left, top + y), domain.width,
                  to.data() + std::ptrdiff_t(y) * domain.width);
  }
  return noise;
}

} // namespace

NoisePlanes discreteSpotNoise(const Spot& spot, double intensity, const PixelDomain& domain,
                              std::uint64_t seed, Summation summation) {
  assert(intensity > 0.0);
  const PixelDomain points = pointDomain(domain, spot);
  std::vector<float> counts = poissonCounts(points, intensity, seed);
  const double scale = 1.0 / std::sqrt(intensity);
  if (summation == Summation::spectral) {
    // Subtract the mean first, so that the transforms' rounding is relative to the variation.
    for (float& count : counts)
      count = float((double(count) - intensity) * scale);
    return convolvedBySpectra(spot, counts, points, domain);
  }
  NoisePlanes noise = summedDirectly(spot, pointRows(points, counts), domain);
  for (int c = 0; c < spot.channels; ++c) {
    const std::span<const float> values = plane(spot, c);
    const double mean = intensity * std::accumulate(values.begin(), values.end(), 0.0);
    for (float& value : plane(noise, c))
      value = float((double(value) - mean) * scale);
  }
  return noise;
}

NoisePlanes gaussianSpotNoise(const Spot& spot, const PixelDomain& domain, std::uint64_t seed) {
  const PixelDomain points = pointDomain(domain, spot);
  return convolvedBySpectra(spot, gaussianWhiteNoise(points, seed), points, domain);
}

} // namespace lichen::gaussian
