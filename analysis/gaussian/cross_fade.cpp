// SPDX-License-Identifier: MIT
// Gaussian image (width * height points) -> the same with matching borders.
#include "cross_fade.h"

#include "gaussian_distribution.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::gaussian {
namespace {

/// Width of the cross-faded band on each side of a border, as a share of the side. The total is an
/// eighth; docs/decisions/006-light-and-grain.md chose a half for streaks.
constexpr double kBandPerSide = 1.0 / 16.0;
constexpr double kStreakBandPerSide = 1.0 / 4.0;
/// Deviation of the average that leaves the streaks, as a share of the side along the grain:
/// docs/decisions/006-light-and-grain.md.
constexpr double kStreakAveragePerSide = 3.0 / 64.0;

enum class Axis { x, y };

/// The rows of an image, which lie along x, or its columns, which lie along y.
struct AxisLines {
  int count;
  int length; ///< pixels of a line
  std::size_t lineStride;
  std::size_t pixelStride;

  AxisLines(Axis along, int width, int height)
      : count(along == Axis::x ? height : width), length(along == Axis::x ? width : height),
        lineStride(along == Axis::x ? std::size_t(width) : 1u),
        pixelStride(along == Axis::x ? 1u : std::size_t(width)) {}

  /// The index in the image of pixel k of a line.
  [[nodiscard]] std::size_t pixel(int line, int k) const {
    return std::size_t(line) * lineStride + std::size_t(k) * pixelStride;
  }
};

constexpr std::array<float Point::*, 3> kChannels{&Point::x, &Point::y, &Point::z};

/// Returns the weight of the displaced image at pixel k of a side: 1 on the seam and 0 outside the
/// band, with a smooth step between, so that the band has no visible edge.
double seamWeight(int k, int side, double bandPerSide) {
  const int fromSeam = std::min(k, side - 1 - k);
  const double t = 1.0 - std::min(1.0, fromSeam / std::max(1.0, bandPerSide * side));
  return t * t * (3.0 - 2.0 * t);
}

/// Fades the borders at the ends of an axis. Values half a side apart have this correlation.
void fade(std::vector<Point>& image, const AxisLines& lines, double mean, double bandPerSide,
          double correlation) {
  std::vector<Point> line(std::size_t(lines.length));
  for (int l = 0; l < lines.count; ++l) {
    for (int k = 0; k < lines.length; ++k)
      line[std::size_t(k)] = image[lines.pixel(l, k)];
    for (int k = 0; k < lines.length; ++k) {
      const double b = seamWeight(k, lines.length, bandPerSide), a = 1.0 - b;
      const double scale = 1.0 / std::sqrt(a * a + b * b + 2.0 * correlation * a * b);
      const Point& displaced = line[std::size_t((k + lines.length / 2) % lines.length)];
      for (float Point::*const channel : kChannels)
        image[lines.pixel(l, k)].*channel =
            float(mean + scale * (a * (double(line[std::size_t(k)].*channel) - mean) +
                                  b * (double(displaced.*channel) - mean)));
    }
  }
}

void fadeBoth(std::vector<Point>& image, int width, int height, double mean) {
  fade(image, AxisLines(Axis::x, width, height), mean, kBandPerSide, 0.0);
  fade(image, AxisLines(Axis::y, width, height), mean, kBandPerSide, 0.0);
}

/// Replaces each value of a line by the mean of `radius` values on both sides; the line is mirrored
/// at its ends.
void average(std::vector<double>& line, int radius) {
  const int length = int(line.size());
  const auto mirrored = [&](int k) {
    return line[std::size_t(k < 0 ? -1 - k : k >= length ? 2 * length - 1 - k : k)];
  };
  std::vector<double> means(line.size());
  double sum = 0.0;
  for (int k = -1 - radius; k < radius; ++k)
    sum += mirrored(k);
  for (int k = 0; k < length; ++k) {
    sum += mirrored(k + radius) - mirrored(k - radius - 1);
    means[std::size_t(k)] = sum / (2 * radius + 1);
  }
  line = std::move(means);
}

/// The average along each line: close to a Gaussian one, of three means.
std::vector<Point> streaksOf(const std::vector<Point>& image, const AxisLines& lines) {
  const double deviation = kStreakAveragePerSide * lines.length;
  const int radius = std::min(int(std::lround(deviation)), lines.length / 2);
  std::vector<Point> streaks(image.size());
  std::vector<double> line(std::size_t(lines.length));
  for (int l = 0; l < lines.count; ++l)
    for (float Point::*const channel : kChannels) {
      for (int k = 0; k < lines.length; ++k)
        line[std::size_t(k)] = double(image[lines.pixel(l, k)].*channel);
      for (int pass = 0; pass < 3; ++pass)
        average(line, radius);
      for (int k = 0; k < lines.length; ++k)
        streaks[lines.pixel(l, k)].*channel = float(line[std::size_t(k)]);
    }
  return streaks;
}

/// The correlation of values half a side apart, in [0, 1], over all channels together. Channels
/// that the image does not use are constant.
double halvesCorrelation(const std::vector<Point>& image, const AxisLines& lines) {
  const int half = lines.length / 2;
  double product = 0.0, first = 0.0, second = 0.0;
  for (float Point::*const channel : kChannels) {
    double mean = 0.0;
    for (const Point& value : image)
      mean += double(value.*channel);
    mean /= double(image.size());
    for (int l = 0; l < lines.count; ++l)
      for (int k = 0; k < half; ++k) {
        const double a = double(image[lines.pixel(l, k)].*channel) - mean;
        const double b = double(image[lines.pixel(l, k + half)].*channel) - mean;
        product += a * b;
        first += a * a;
        second += b * b;
      }
  }
  const double norm = std::sqrt(first * second);
  return norm > 0.0 ? std::clamp(product / norm, 0.0, 1.0) : 0.0;
}

void fadeAlongGrain(std::vector<Point>& image, int width, int height, Axis grain) {
  const AxisLines along(grain, width, height);
  std::vector<Point> streaks = streaksOf(image, along);
  for (std::size_t i = 0; i < image.size(); ++i)
    for (float Point::*const channel : kChannels)
      image[i].*channel -= streaks[i].*channel;
  fadeBoth(image, width, height, 0.0); // without the streaks, about 0
  fade(streaks, along, kGaussianMean, kStreakBandPerSide, halvesCorrelation(streaks, along));
  fade(streaks, AxisLines(grain == Axis::x ? Axis::y : Axis::x, width, height), kGaussianMean,
       kBandPerSide, 0.0);
  for (std::size_t i = 0; i < image.size(); ++i)
    for (float Point::*const channel : kChannels)
      image[i].*channel += streaks[i].*channel;
}

} // namespace

std::vector<Point> crossFadeBorders(const std::vector<Point>& image, int width, int height,
                                    Grain grain) {
  std::vector<Point> faded = image;
  if (grain == Grain::none)
    fadeBoth(faded, width, height, kGaussianMean);
  else
    fadeAlongGrain(faded, width, height, grain == Grain::x ? Axis::x : Axis::y);
  return faded;
}

} // namespace lichen::gaussian
