// SPDX-License-Identifier: MIT
#include "border_misfit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace lichen::placement {

BorderMisfit::BorderMisfit(const exemplar::ImageLevel& image) : image_(image) {
  const auto channels = std::size_t(image.channels);
  const double count = double(image.width) * image.height;
  std::vector<double> sums(channels), squares(channels);
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    sums[i % channels] += double(image.values[i]);
    squares[i % channels] += double(image.values[i]) * double(image.values[i]);
  }
  for (std::size_t c = 0; c < channels; ++c)
    unrelated_ += 2.0 * std::max(0.0, squares[c] / count - std::pow(sums[c] / count, 2.0));
}

double BorderMisfit::between(const std::array<double, 2>& from, const std::array<double, 2>& side,
                             const std::array<double, 2>& apart) const {
  constexpr int kWinding = 2; // pixels
  const auto channels = std::size_t(image_.channels);
  const auto pixelAt = [&](double x, double y) {
    const int column = std::clamp(int(std::floor(x)), 0, image_.width - 1);
    const int row = std::clamp(int(std::floor(y)), 0, image_.height - 1);
    return &image_.values[(std::size_t(row) * std::size_t(image_.width) + std::size_t(column)) *
                          channels];
  };
  const double distance = std::max(1.0, std::hypot(apart[0], apart[1])); // of a pixel: 0
  const int samples = std::max(1, int(std::hypot(side[0], side[1])));
  double sum = 0.0;
  for (int k = 0; k < samples; ++k) {
    const double along = (k + 0.5) / samples;
    const double x = from[0] + along * side[0], y = from[1] + along * side[1];
    const float* const near = pixelAt(x, y);
    double least = 0.0;
    for (int across = -kWinding; across <= kWinding; ++across) {
      const double share = 1.0 + across / distance;
      const float* const far = pixelAt(x + share * apart[0], y + share * apart[1]);
      double squares = 0.0;
      for (std::size_t c = 0; c < channels; ++c)
        squares += std::pow(double(near[c]) - double(far[c]), 2.0);
      least = across == -kWinding ? squares : std::min(least, squares);
    }
    sum += least;
  }
  constexpr double kNoVariance = 1e-4; // a deviation of two code values
  return unrelated_ > 2.0 * kNoVariance ? sum / (samples * unrelated_) : 0.0;
}

bool BorderMisfit::bordersLookAlike(std::size_t axis) const {
  constexpr double kMostMisfit = 0.125; // docs/decisions/012-quilting.md
  const double width = image_.width, height = image_.height;
  const std::array<double, 2> from{0.0, 0.0};
  return (axis == 0 ? between(from, {0.0, height}, {width - 1.0, 0.0})
                    : between(from, {width, 0.0}, {0.0, height - 1.0})) < kMostMisfit;
}

} // namespace lichen::placement
