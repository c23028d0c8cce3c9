// SPDX-License-Identifier: MIT
// Images (height, width, channels each) -> channels of one x channels of the other.
#include "set_covariances.h"

#include <cmath>

namespace lichen::test {
namespace {

/// The values of each channel minus their mean.
std::vector<std::vector<double>> centredChannels(const LinearImage& image) {
  std::vector<std::vector<double>> channels(std::size_t(image.channels));
  for (std::size_t i = 0; i < image.values.size(); ++i)
    channels[i % channels.size()].push_back(double(image.values[i]));
  for (std::vector<double>& values : channels) {
    double mean = 0.0;
    for (const double value : values)
      mean += value / double(values.size());
    for (double& value : values)
      value -= mean;
  }
  return channels;
}

} // namespace

std::vector<double> crossCovariances(const LinearImage& a, const LinearImage& b) {
  const std::vector<std::vector<double>> ofA = centredChannels(a), ofB = centredChannels(b);
  std::vector<double> covariances;
  for (const std::vector<double>& x : ofA)
    for (const std::vector<double>& y : ofB) {
      double sum = 0.0;
      for (std::size_t i = 0; i < x.size(); ++i)
        sum += x[i] * y[i];
      covariances.push_back(sum / double(x.size()));
    }
  return covariances;
}

std::vector<LinearImage> decodedMaps(std::span<const MapExemplar> maps) {
  std::vector<LinearImage> images;
  for (const MapExemplar& map : maps) {
    images.emplace_back(map.width, map.height, int(map.channels.size()));
    images.back().values = map.values;
    if (map.encoding == ValueEncoding::srgb)
      for (float& value : images.back().values)
        value = srgbToLinear(value);
  }
  return images;
}

double norm(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value * value;
  return std::sqrt(sum);
}

} // namespace lichen::test
