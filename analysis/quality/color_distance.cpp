// SPDX-License-Identifier: MIT
// Sliced Wasserstein-2 distance between two sets of colours.
//
// Two images of n and m pixels with 1 or 3 colour channels -> one number. Source: [RPDB12].
#include "boundary.h"

#include <lichen/quality.h>

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace lichen {
namespace {

constexpr int kDirections = 256; // fixed, so that values can be compared
constexpr int kSteps = 1 << 16;  // of a projection; rounding changes a distance by less than a step

using Vector = std::array<double, 3>;

/// Unit vectors spread evenly over a half sphere (Fibonacci lattice); for grey, its only axis.
std::vector<Vector> directions(int channels) {
  if (channels == 1)
    return {{1.0, 0.0, 0.0}};
  std::vector<Vector> all;
  const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < kDirections; ++i) {
    const double z = (i + 0.5) / kDirections;
    const double radius = std::sqrt(1.0 - z * z);
    all.push_back({radius * std::cos(goldenAngle * i), radius * std::sin(goldenAngle * i), z});
  }
  return all;
}

/// The range of each colour channel over both images.
struct Bounds {
  Vector low{0.0, 0.0, 0.0};
  Vector high{0.0, 0.0, 0.0};
};

void extend(Bounds& bounds, const SrgbImage& image, bool first) {
  const int channels = colorChannels(image);
  for (int c = 0; c < channels; ++c) {
    const auto k = std::size_t(c);
    if (first)
      bounds.low[k] = bounds.high[k] = double(image.values[k]);
    for (std::size_t i = k; i < image.values.size(); i += std::size_t(image.channels)) {
      bounds.low[k] = std::min(bounds.low[k], double(image.values[i]));
      bounds.high[k] = std::max(bounds.high[k], double(image.values[i]));
    }
  }
}

/// The range of projections that the bounds allow, in kSteps steps.
struct Scale {
  double low;
  double step;
};

Scale projectionScale(const Bounds& bounds, const Vector& direction) {
  double low = 0.0, high = 0.0;
  for (std::size_t c = 0; c < direction.size(); ++c) {
    low += std::min(direction[c] * bounds.low[c], direction[c] * bounds.high[c]);
    high += std::max(direction[c] * bounds.low[c], direction[c] * bounds.high[c]);
  }
  return {low, (high - low) / kSteps};
}

/// The number of pixels in each step of the projection.
std::vector<std::uint32_t> projected(const SrgbImage& image, const Vector& direction,
                                     const Scale& scale) {
  std::vector<std::uint32_t> histogram(kSteps, 0);
  const bool color = colorChannels(image) == 3;
  const auto u =
      std::array<float, 3>{float(direction[0]), float(direction[1]), float(direction[2])};
  const auto low = float(scale.low);
  const auto perStep = scale.step > 0.0 ? float(1.0 / scale.step) : 0.0f;
  const float* p = image.values.data();
  for (std::size_t i = 0; i < image.pixelCount(); ++i, p += image.channels) {
    const float position = color ? u[0] * p[0] + u[1] * p[1] + u[2] * p[2] : u[0] * p[0];
    const int step = std::clamp(int((position - low) * perStep), 0, kSteps - 1);
    ++histogram[std::size_t(step)];
  }
  return histogram;
}

/// Squared Wasserstein-2 distance in steps: the integral over u of the squared difference between
/// the two quantile functions, which are piecewise constant.
double squaredDistance(const std::vector<std::uint32_t>& a, std::size_t countA,
                       const std::vector<std::uint32_t>& b, std::size_t countB) {
  // Masses are integers in units of 1 / (countA countB), so rounding leaves no remainder.
  std::size_t i = 0, j = 0;
  std::uint64_t massA = a[0] * std::uint64_t(countB);
  std::uint64_t massB = b[0] * std::uint64_t(countA);
  double sum = 0.0;
  for (;;) {
    while (massA == 0 && ++i < a.size())
      massA = a[i] * std::uint64_t(countB);
    while (massB == 0 && ++j < b.size())
      massB = b[j] * std::uint64_t(countA);
    if (i >= a.size() || j >= b.size())
      break;
    const std::uint64_t moved = std::min(massA, massB);
    const double distance = double(i) - double(j);
    sum += double(moved) * distance * distance;
    massA -= moved;
    massB -= moved;
  }
  return sum / (double(countA) * double(countB));
}

} // namespace

Result<double> colorDistance(const SrgbImage& exemplar, const SrgbImage& result) {
  return withinMemory(exhausted, [&]() -> Result<double> {
    if (auto error = refusal(exemplar, result, 1))
      return *error;
    Bounds bounds;
    extend(bounds, exemplar, true);
    extend(bounds, result, false);
    const std::vector<Vector> all = directions(colorChannels(exemplar));
    std::vector<double> squares(all.size(), 0.0);
    tbb::parallel_for(std::size_t(0), all.size(), [&](std::size_t k) {
      const Scale scale = projectionScale(bounds, all[k]);
      squares[k] = scale.step * scale.step *
                   squaredDistance(projected(exemplar, all[k], scale), exemplar.pixelCount(),
                                   projected(result, all[k], scale), result.pixelCount());
    });
    double sum = 0.0;
    for (const double square : squares)
      sum += square;
    return std::sqrt(sum / double(all.size()));
  });
}

} // namespace lichen
