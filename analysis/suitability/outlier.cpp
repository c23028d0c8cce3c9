// SPDX-License-Identifier: MIT
// Colours (height, width, channels) -> the part that stands out, through the Mahalanobis distance
// of differences of Gaussians at four scales.
#include "outlier.h"

#include "calibration.h"
#include "exemplar/resample.h"
#include "exemplar/value_encoding.h"
#include "trend.h"

#include <lichen/fft.h>
#include <lichen/image.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace lichen::suitability {
namespace {

constexpr int kSmallestSide = 128;
constexpr int kSearchSide = 256;         // longer side of the map that is searched
constexpr int kSmallestReducedSide = 64; // four times the largest scale

/// The scales, as divisors of the longer side.
constexpr std::array<double, 4> kScales{64.0, 40.0, 25.0, 16.0};

// Standard deviations of the Gaussians, in scales.
constexpr double kPlace = 0.5, kSurroundings = 3.0;

/// A channel in sRGB codes, without its trend.
Plane codesOf(const MapExemplar& map, std::size_t channel) {
  Plane plane{map.width, map.height, {}};
  for (std::size_t i = channel; i < map.values.size(); i += map.channels.size())
    plane.values.push_back(linearToSrgb(exemplar::decoded(map.values[i], map.encoding)));
  const Plane trend = trendOf(plane, false);
  for (std::size_t i = 0; i < plane.values.size(); ++i)
    plane.values[i] -= trend.values[i];
  return plane;
}

/// What the difference of Gaussians leaves of each wave of the spectrum, in its order.
std::vector<float> gainsAt(double scale, const HalfSpectrum& spectrum) {
  std::vector<float> gains;
  gains.reserve(spectrum.values.size());
  for (int v = 0; v < spectrum.height; ++v)
    for (int u = 0; u < spectrum.columns(); ++u) {
      const double turn =
          2.0 * std::numbers::pi * scale *
          std::hypot(double(u) / spectrum.width, double(spectrum.signedRow(v)) / spectrum.height);
      const auto gain = [&](double deviation) {
        return std::exp(-0.5 * deviation * deviation * turn * turn);
      };
      gains.push_back(float(gain(kPlace) - gain(kSurroundings)));
    }
  return gains;
}

/// The differences of all places from their surroundings: (pixels, channels).
Eigen::MatrixXd differences(std::span<const HalfSpectrum> channels, int width, int height,
                            double scale) {
  Eigen::MatrixXd result(Eigen::Index(width) * height, Eigen::Index(channels.size()));
  const std::vector<float> gains = gainsAt(scale, channels.front());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    HalfSpectrum band = channels[c];
    for (std::size_t i = 0; i < gains.size(); ++i)
      band.values[i] *= gains[i];
    const std::vector<float> plane = inverseFft(band);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        result(Eigen::Index(y) * width + x, Eigen::Index(c)) =
            double(plane[std::size_t(y) * std::size_t(band.width) + std::size_t(x)]);
  }
  return result;
}

/// The Mahalanobis distance of each row from 0. The covariance is taken over the rows with all but
/// the 2 % largest distances, by iteration, plus the variance of rounding to 8 bits.
std::vector<float> distances(const Eigen::MatrixXd& rows) {
  constexpr double kUsual = 0.98, kRounding = 1.0 / 255.0 / 255.0 / 12.0;
  const Eigen::Index channels = rows.cols();
  std::vector<double> squares(std::size_t(rows.rows()), 0.0);
  double most = 0.0;
  for (int iteration = 0; iteration < 3; ++iteration) {
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(channels, channels);
    double count = 0.0;
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      if (squares[std::size_t(i)] <= most) {
        covariance += rows.row(i).transpose() * rows.row(i);
        count += 1.0;
      }
    covariance = covariance / count + kRounding * Eigen::MatrixXd::Identity(channels, channels);
    const Eigen::MatrixXd scaled = covariance.ldlt().solve(rows.transpose()).transpose();
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      squares[std::size_t(i)] = scaled.row(i).dot(rows.row(i));
    std::vector<double> sorted = squares;
    const auto usual = sorted.begin() + std::ptrdiff_t(kUsual * double(sorted.size() - 1));
    std::ranges::nth_element(sorted, usual);
    most = *usual;
  }
  std::vector<float> result;
  for (const double square : squares)
    result.push_back(float(std::sqrt(std::max(square, 0.0))));
  return result;
}

/// The pixels above `level` that are connected with pixel `from` along rows and columns.
std::vector<std::size_t> connected(const std::vector<float>& values, int width, std::size_t from,
                                   float level) {
  std::vector<bool> seen(values.size());
  std::vector<std::size_t> found{from};
  seen[from] = true;
  const auto side = std::size_t(width);
  for (std::size_t next = 0; next < found.size(); ++next) {
    const std::size_t pixel = found[next];
    const auto visit = [&](bool exists, std::size_t neighbour) {
      if (!exists || seen[neighbour] || values[neighbour] <= level)
        return;
      seen[neighbour] = true;
      found.push_back(neighbour);
    };
    visit(pixel % side > 0, pixel - 1);
    visit(pixel % side + 1 < side, pixel + 1);
    visit(pixel >= side, pixel - side);
    visit(pixel + side < values.size(), pixel + side);
  }
  return found;
}

/// Sets the values in and around the pixels to 0.
void erase(std::vector<float>& values, int width, std::span<const std::size_t> pixels,
           int distance) {
  const int height = int(values.size()) / width;
  for (const std::size_t pixel : pixels) {
    const int px = int(pixel) % width, py = int(pixel) / width;
    for (int y = std::max(0, py - distance); y <= std::min(height - 1, py + distance); ++y)
      for (int x = std::max(0, px - distance); x <= std::min(width - 1, px + distance); ++x)
        values[std::size_t(y) * std::size_t(width) + std::size_t(x)] = 0.0f;
  }
}

/// A place that stands out at one scale.
struct Strongest {
  double ratio = 0.0;     ///< its distance over the third strongest place's
  std::size_t middle = 0; ///< the pixel that differs most
  Part part;
  std::vector<bool> unusual;
};

Strongest strongestAt(const std::vector<float>& distances, int width, double scale) {
  constexpr float kSamePlace = 0.45f; // share of a place's distance down to which it reaches
  constexpr double kApart = 1.5;      // scales between two places
  std::vector<float> left = distances;
  std::array<float, 3> places{};
  std::size_t first = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto most = std::size_t(std::ranges::max_element(left) - left.begin());
    places[k] = left[most];
    if (k == 0)
      first = most;
    erase(left, width, connected(left, width, most, kSamePlace * places[k]),
          int(std::lround(kApart * scale)));
  }
  if (!(places[2] > 0.0f))
    return {};
  constexpr float kUnusual = 0.8f; // of the third place's distance
  constexpr float kReach = 0.15f;  // of the first's: its surroundings differ from it, too
  const float unusualLevel = kUnusual * places[2];
  const float level = std::max(unusualLevel, kReach * places[0]);
  const int margin = int(std::lround(0.5 * scale)), height = int(distances.size()) / width;
  int fromX = width, fromY = height, toX = 0, toY = 0;
  for (const std::size_t pixel : connected(distances, width, first, level)) {
    const int x = int(pixel) % width, y = int(pixel) / width;
    fromX = std::min(fromX, x - margin);
    fromY = std::min(fromY, y - margin);
    toX = std::max(toX, x + margin + 1);
    toY = std::max(toY, y + margin + 1);
  }
  fromX = std::max(fromX, 0);
  fromY = std::max(fromY, 0);
  std::vector<bool> unusual(distances.size());
  std::transform(distances.begin(), distances.end(), unusual.begin(),
                 [&](float distance) { return distance > unusualLevel; });
  return {double(places[0] / places[2]),
          first,
          {fromX, fromY, std::min(toX, width) - fromX, std::min(toY, height) - fromY},
          std::move(unusual)};
}

} // namespace

std::optional<Outlier> outlierOf(const MapExemplar& map) {
  if (std::min(map.width, map.height) < kSmallestSide)
    return std::nullopt;
  const double reduction = std::min(1.0, double(kSearchSide) / std::max(map.width, map.height));
  const auto side = [&](int pixels) { return std::max(1, int(std::lround(reduction * pixels))); };
  MapExemplar reduced =
      reduction < 1.0 ? exemplar::resampled(map, side(map.width), side(map.height), false) : map;
  if (std::min(reduced.width, reduced.height) < kSmallestReducedSide)
    return std::nullopt;
  std::vector<HalfSpectrum> channels;
  for (std::size_t c = 0; c < reduced.channels.size(); ++c) {
    const Plane whole = mirrored(codesOf(reduced, c));
    channels.push_back(forwardFft(whole.values, whole.width, whole.height));
  }
  Strongest best;
  for (const double divisor : kScales) {
    const double scale = std::max(reduced.width, reduced.height) / divisor;
    const Eigen::MatrixXd rows = differences(channels, reduced.width, reduced.height, scale);
    Strongest strongest = strongestAt(distances(rows), reduced.width, scale);
    const double difference = rows.row(Eigen::Index(strongest.middle)).norm();
    const double visible = kVisibleOutlier * std::sqrt(double(rows.cols()));
    if (strongest.ratio > best.ratio && difference >= visible)
      best = std::move(strongest);
  }
  if (best.ratio < kOutlier)
    return std::nullopt;
  return Outlier{std::move(reduced), best.part, std::move(best.unusual)};
}

} // namespace lichen::suitability
