// SPDX-License-Identifier: MIT
// Index map (height, width) -> the autocovariance of the indicator inside its region -> correlation
// of the field [T91] -> its amplitudes (2 rows + 1, 2 columns + 1).
#include "index_spectrum.h"

#include "level_cut.h"

#include <lichen/fft.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace lichen::layers {
namespace {

/// The sum over all x of a(x) b(x + lag), of planes with zeros around them.
class LagSums {
public:
  LagSums(int width, int height)
      : width_(width), height_(height), paddedWidth_(fastTransformSize(width + width / 2)),
        paddedHeight_(fastTransformSize(height + height / 2)) {}

  [[nodiscard]] HalfSpectrum transform(std::span<const float> plane) const {
    std::vector<float> padded(std::size_t(paddedWidth_) * std::size_t(paddedHeight_), 0.0f);
    for (int y = 0; y < height_; ++y)
      std::copy_n(&plane[std::size_t(y) * std::size_t(width_)], width_,
                  &padded[std::size_t(y) * std::size_t(paddedWidth_)]);
    return forwardFft(padded, paddedWidth_, paddedHeight_);
  }

  [[nodiscard]] std::vector<float> sums(const HalfSpectrum& a, const HalfSpectrum& b) const {
    std::vector<float> means = inverseFft(crossSpectrum(a, b));
    for (float& mean : means)
      mean *= float(paddedWidth_) * float(paddedHeight_);
    return means;
  }

  /// Where the sums have a lag, which is at most half a side.
  [[nodiscard]] std::size_t at(int dx, int dy) const {
    return std::size_t((dy + paddedHeight_) % paddedHeight_) * std::size_t(paddedWidth_) +
           std::size_t((dx + paddedWidth_) % paddedWidth_);
  }

private:
  int width_, height_, paddedWidth_, paddedHeight_;
};

/// Falls from 1 to 0 by a cosine. `reach` is 1 at half the tile.
double taper(double reach) {
  return reach < 1.0 ? 0.5 + 0.5 * std::cos(std::numbers::pi * reach) : 0.0;
}

/// How far a lag is, as taper() takes it.
double reachOf(const IndexMap& map, int column, int row) {
  const int dx = column <= map.width / 2 ? column : column - map.width;
  const int dy = row <= map.height / 2 ? row : row - map.height;
  return std::hypot(2.0 * dx / map.width, 2.0 * dy / map.height);
}

/// The indicator at a lag.
struct Lag {
  double reach = 1.0;
  double covariance = 0.0;
};

/// In the order of fieldCorrelation().
std::vector<Lag> lagsOf(const IndexMap& map) {
  const LagSums sums(map.width, map.height);
  const HalfSpectrum region = sums.transform(map.region), above = sums.transform(map.above);
  const std::vector<float> pairs = sums.sums(region, region), both = sums.sums(above, above),
                           first = sums.sums(above, region), second = sums.sums(region, above);
  // A covariance of fewer pairs is mostly chance.
  const double fewest = 0.01 * double(pairs[0]);
  std::vector<Lag> lags(std::size_t(map.width) * std::size_t(map.height));
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column) {
      const int dx = column <= map.width / 2 ? column : column - map.width;
      const int dy = row <= map.height / 2 ? row : row - map.height;
      const std::size_t at = sums.at(dx, dy);
      const double count = pairs[at];
      Lag& lag = lags[std::size_t(row) * std::size_t(map.width) + std::size_t(column)];
      lag.reach = reachOf(map, column, row);
      // With the means of the two ends of the pairs: their chance differences cancel.
      if (count > fewest)
        lag.covariance = both[at] / count - (first[at] / count) * (second[at] / count);
    }
  return lags;
}

/// The deviation of covariances by chance, taken from far lags, where most fields do not correlate.
double chance(const std::vector<Lag>& lags) {
  constexpr double kFar = 0.75;
  double sum = 0.0, count = 0.0;
  for (const Lag& lag : lags)
    if (lag.reach > kFar && lag.reach < 1.0) {
      sum += lag.covariance * lag.covariance;
      count += 1.0;
    }
  return std::sqrt(sum / std::max(1.0, count));
}

} // namespace

double IndexMap::proportion() const {
  return std::accumulate(above.begin(), above.end(), 0.0) /
         std::accumulate(region.begin(), region.end(), 0.0);
}

std::vector<float> fieldCorrelation(const IndexMap& map) {
  const LevelCut cut(map.proportion());
  const std::vector<Lag> lags = lagsOf(map);
  const double noise = chance(lags);
  std::vector<float> correlation;
  correlation.reserve(lags.size());
  for (const Lag& lag : lags) {
    if (lag.reach >= 1.0) {
      correlation.push_back(0.0f);
      continue;
    }
    const double found = cut.correlation(lag.covariance);
    // The most likely correlation, if correlations are normal with this deviation. Rare labels
    // barely show weak correlations, and their chance would raise the whole spectrum.
    constexpr double kExpected = 0.3;
    const double deviation = noise / std::max(1e-12, cut.slope(found));
    const double share = 1.0 / (1.0 + std::pow(deviation / kExpected, 2.0));
    correlation.push_back(float(taper(lag.reach) * share * found));
  }
  correlation[0] = 1.0f;
  return correlation;
}

SpectrumPicture indexSpectrum(const IndexMap& map) {
  constexpr int kMostCycles = 128; // finer patches are not worth a fit of all of them
  const int columns = std::min(map.width / 4, kMostCycles);
  const int rows = std::min(map.height / 4, kMostCycles);
  const HalfSpectrum transform = forwardFft(fieldCorrelation(map), map.width, map.height);
  const auto ringOf = [](int u, int v) { return std::size_t(std::lround(std::hypot(u, v))); };
  const auto powerAt = [&](int u, int v) {
    const int row = u < 0 ? -v : v; // (u, v) and (-u, -v) have the same power
    return double(transform.at(std::abs(u), (row + map.height) % map.height).real());
  };
  // Powers that are negative by chance become 0. Others of the same ring of frequencies are reduced
  // by as much: a field of smooth outlines has so little power at high frequencies that chance
  // would fray them.
  std::vector<double> all(ringOf(columns, rows) + 1, 0.0), positive = all;
  for (int v = -rows; v <= rows; ++v)
    for (int u = -columns; u <= columns; ++u) {
      all[ringOf(u, v)] += powerAt(u, v);
      positive[ringOf(u, v)] += std::max(0.0, powerAt(u, v));
    }
  SpectrumPicture picture{2 * columns + 1, 2 * rows + 1, {}};
  double sum = 0.0;
  for (int v = -rows; v <= rows; ++v)
    for (int u = -columns; u <= columns; ++u) {
      const std::size_t ring = ringOf(u, v);
      double power = 0.0;
      if (ring > 0 && all[ring] > 0.0)
        power = std::max(0.0, powerAt(u, v)) * all[ring] / positive[ring];
      sum += power;
      picture.amplitudes.push_back(float(std::sqrt(power)));
    }
  if (sum > 0.0)
    for (float& amplitude : picture.amplitudes)
      amplitude /= float(std::sqrt(sum));
  return picture;
}

} // namespace lichen::layers
