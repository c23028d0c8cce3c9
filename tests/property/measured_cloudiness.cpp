// SPDX-License-Identifier: MIT
#include "measured_cloudiness.h"

#include <lichen/lattice.h>

#include <cassert>
#include <cmath>
#include <gaussianization/map_fit.h>
#include <gaussianization/table_lookup.h>

namespace lichen::test {

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  return sum / double(values.size());
}

double variance(const std::vector<double>& values) {
  const double about = mean(values);
  double sum = 0.0;
  for (const double value : values)
    sum += (value - about) * (value - about);
  return sum / double(values.size());
}

double measuredCloudiness(const MapExemplar& map, int samples) {
  const gaussianization::MapFit fit = gaussianization::fitMap(
      map, exemplar::colorSpaceOf(map), {.transport = TransportEffort::fast, .share = 0.1f});
  assert(fit.table.dimensions == 3);
  gaussianization::InverseTable codes = fit.table;
  for (float& value : codes.values)
    value = linearToSrgb(value);
  const gaussianization::TableLookup<3> lookup(codes);
  const auto tap = [&](int sample, int k, int x, int y) {
    const auto offset = pcg3d({std::uint32_t(sample), std::uint32_t(k), 7u});
    const auto column = (std::size_t(x) + offset[0]) % std::size_t(map.width);
    const auto row = (std::size_t(y) + offset[1]) % std::size_t(map.height);
    return fit.gaussian.image[row * std::size_t(map.width) + column];
  };
  std::vector<double> variances;
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<double> luminance;
    for (int y = 0; y < map.height; y += 2) // every second pixel is enough for slow variation
      for (int x = 0; x < map.width; x += 2) {
        std::array<float, 3> sum{};
        for (int k = 0; k < 3; ++k) {
          const Point g = tap(sample, k, x, y);
          sum[0] += g.x - 0.5f;
          sum[1] += g.y - 0.5f;
          sum[2] += g.z - 0.5f;
        }
        const float norm = 1.0f / std::sqrt(3.0f);
        const auto code =
            lookup({0.5f + norm * sum[0], 0.5f + norm * sum[1], 0.5f + norm * sum[2]});
        luminance.push_back(0.2126 * double(code[0]) + 0.7152 * double(code[1]) +
                            0.0722 * double(code[2]));
      }
    variances.push_back(variance(luminance));
  }
  return std::sqrt(variance(variances)) / mean(variances);
}

} // namespace lichen::test
