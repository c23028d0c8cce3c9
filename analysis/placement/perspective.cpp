// SPDX-License-Identifier: MIT
// Picture -> its correlation without a keystone of several strengths -> the best of them.
//
// docs/decisions/012-quilting.md says how the constants were chosen.
#include "perspective.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lichen::placement {

using exemplar::ImageLevel;

namespace {

/// One channel, the mean of all.
ImageLevel gray(const ImageLevel& image) {
  ImageLevel result{image.width, image.height, 1, {}};
  const auto channels = std::size_t(image.channels);
  for (std::size_t i = 0; i < image.values.size(); i += channels) {
    float sum = 0.0f;
    for (std::size_t c = 0; c < channels; ++c)
      sum += image.values[i + c];
    result.values.push_back(sum / float(channels));
  }
  return result;
}

float valueAt(const ImageLevel& image, int x, int y, std::size_t channel) {
  x = std::clamp(x, 0, image.width - 1);
  y = std::clamp(y, 0, image.height - 1);
  return image.values[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) *
                          std::size_t(image.channels) +
                      channel];
}

/// Weighted 1 : 2 : 1 along both axes.
ImageLevel smoothed(const ImageLevel& image) {
  ImageLevel result = image;
  float* value = result.values.data();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < std::size_t(image.channels); ++c) {
        float sum = 0.0f;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            sum +=
                float((2 - std::abs(dx)) * (2 - std::abs(dy))) * valueAt(image, x + dx, y + dy, c);
        *value++ = sum / 16.0f;
      }
  return result;
}

/// The unit square as a trapezoid whose side at along = 0 is shorter by this share, or the opposite
/// one if it is negative. [H89] section 2.2.
void squeeze(double share, double& across, double& along) {
  const double shorter = std::abs(share);
  const double from = share < 0.0 ? 1.0 - along : along; // 0 at the short side
  const double scale = 1.0 / (1.0 - shorter * from);
  across = ((1.0 - shorter) * across + 0.5 * shorter * (1.0 - from)) * scale;
  along = (1.0 - shorter) * from * scale;
  if (share < 0.0)
    along = 1.0 - along;
}

} // namespace

std::array<double, 2> seen(const Keystone& keystone, double u, double v) {
  squeeze(keystone.x, v, u);
  squeeze(keystone.y, u, v);
  return {u, v};
}

ImageLevel straightened(const ImageLevel& image, const Keystone& keystone) {
  ImageLevel result = image;
  float* value = result.values.data();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto [u, v] = seen(keystone, (x + 0.5) / image.width, (y + 0.5) / image.height);
      const double fromX = u * image.width - 0.5, fromY = v * image.height - 0.5;
      const int left = int(std::floor(fromX)), top = int(std::floor(fromY));
      const auto right = float(fromX - left), down = float(fromY - top);
      for (std::size_t c = 0; c < std::size_t(image.channels); ++c) {
        const auto along = [&](int row) {
          return (1.0f - right) * valueAt(image, left, row, c) +
                 right * valueAt(image, left + 1, row, c);
        };
        *value++ = (1.0f - down) * along(top) + down * along(top + 1);
      }
    }
  return result;
}

std::optional<Keystone> keystoneOf(const ImageLevel& image, const CorrelationOf& correlationOf) {
  constexpr int kMostSide = 256;
  constexpr double kFirstStep = 0.12, kLastStep = 0.0075;
  constexpr double kLeastStraight = 0.08, kLeast = 0.45; // of the correlation
  constexpr double kSlight = 0.08, kLeastGain = 1.05, kLeastGainOfMore = 1.15;
  ImageLevel reduced = gray(image);
  while (std::max(reduced.width, reduced.height) > kMostSide)
    reduced = exemplar::areaAverage(reduced);
  // Interpolation smooths, and what is smooth correlates more highly: so all are smooth.
  reduced = smoothed(reduced);
  const double straight = correlationOf(reduced);
  if (straight < kLeastStraight || straight * kLeastGain > 1.0)
    return std::nullopt;
  Keystone best;
  double highest = straight;
  const auto tryAround = [&](Keystone from, double step) {
    for (const Keystone& keystone :
         {Keystone{from.x - step, from.y}, Keystone{from.x + step, from.y},
          Keystone{from.x, from.y - step}, Keystone{from.x, from.y + step}})
      if (const double correlation = correlationOf(straightened(reduced, keystone));
          correlation > highest) {
        highest = correlation;
        best = keystone;
      }
  };
  tryAround({}, kFirstStep);
  tryAround({}, 0.5 * kFirstStep);
  for (double step = 0.25 * kFirstStep; step >= kLastStep; step *= 0.5)
    tryAround(best, step);
  const bool isSlight = std::max(std::abs(best.x), std::abs(best.y)) <= kSlight;
  const double leastGain = isSlight ? kLeastGain : kLeastGainOfMore;
  return highest >= kLeast && highest >= leastGain * straight ? std::optional(best) : std::nullopt;
}

} // namespace lichen::placement
