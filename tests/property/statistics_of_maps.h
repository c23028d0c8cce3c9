// SPDX-License-Identifier: MIT
// Exemplars of any kind with given statistics, and statistics of what noises make of them.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/image.h>
#include <lichen/synthesize.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <exemplar/value_encoding.h>
#include <random>
#include <utility>
#include <vector>

namespace lichen::test {

/// One channel of an image or exemplar.
inline std::vector<double> channelOf(const std::vector<float>& values, std::size_t channels,
                                     std::size_t channel) {
  std::vector<double> result;
  for (std::size_t i = channel; i < values.size(); i += channels)
    result.push_back(values[i]);
  return result;
}

inline std::vector<float> decodedValues(const MapExemplar& map) {
  std::vector<float> values = map.values;
  for (float& value : values)
    value = exemplar::decoded(value, map.encoding);
  return values;
}

/// Samples the colours or heights of 512 x 512 texels: every `stride`-th texel along each axis.
inline LinearImage synthesized(const Bundle& bundle, MapTarget target, int stride = 1) {
  SynthesisOptions options;
  options.map = target;
  options.width = options.height = 512 / stride;
  options.stride = stride;
  Result<LinearImage> image = synthesize(bundle, options);
  REQUIRE(image);
  return std::move(image).value();
}

inline double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  return sum / double(values.size());
}

inline double covarianceOf(const std::vector<double>& a, const std::vector<double>& b) {
  const double meanA = meanOf(a), meanB = meanOf(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - meanA) * (b[i] - meanB);
  return sum / double(a.size());
}

inline double correlationOf(const std::vector<double>& a, const std::vector<double>& b) {
  return covarianceOf(a, b) / std::sqrt(covarianceOf(a, a) * covarianceOf(b, b));
}

/// How each channel of a colour map correlates with a height.
inline std::array<double, 3> correlationsWithHeight(const std::vector<float>& color,
                                                    const std::vector<float>& height) {
  std::array<double, 3> result{};
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = correlationOf(channelOf(color, 3, c), channelOf(height, 1, 0));
  return result;
}

/// Independent Gaussian fields of variance 1, averaged over 3 x 3 texels; periodic.
inline std::vector<std::vector<double>> gaussianFields(std::size_t count, std::uint32_t seed,
                                                       int side) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> fields(count);
  for (std::vector<double>& field : fields) {
    std::vector<double> white(std::size_t(side) * std::size_t(side));
    for (double& value : white)
      value = normal(generator);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        double sum = 0.0;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            sum += white[std::size_t((y + dy + side) % side * side + (x + dx + side) % side)];
        field.push_back(sum / 3.0);
      }
  }
  return fields;
}

inline MapExemplar emptyMap(MapTarget target, std::vector<MapChannel> channels,
                            ValueEncoding encoding, int side) {
  MapExemplar map;
  map.target = target;
  map.channels = std::move(channels);
  map.encoding = encoding;
  map.width = map.height = side;
  return map;
}

} // namespace lichen::test
