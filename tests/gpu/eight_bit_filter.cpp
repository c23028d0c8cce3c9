// SPDX-License-Identifier: MIT
#include "eight_bit_filter.h"

#include <algorithm>
#include <cmath>

namespace lichen::test {
namespace {

// A sampler that filters in 8 bits rounds each linear interpolation, by up to 1/2 code. Of an
// interpolation with a random weight w, the result has the mean w^2 + (1 - w)^2 = 2/3 of the
// variance of its ends' errors, and 1/12 more.
constexpr double filterVariance(int interpolations) {
  return interpolations == 0 ? 0.0 : 2.0 / 3.0 * filterVariance(interpolations - 1) + 1.0 / 12.0;
}
/// Also, weights are multiples of 1/256, between texels that differ by sqrt(2) / 6. [codes^2]
constexpr double kWeightVariance = 2.0 * 255.0 * 255.0 / 36.0 / (12.0 * 256.0 * 256.0);

/// Of one fetch of an 8-bit table, whose cells differ too little for the weights to matter.
double tableDeviation() { return std::sqrt(filterVariance(4)) / 255.0; }

} // namespace

double fetchDeviation() {
  // Between columns, rows and levels. Three independent tiles, the squares of their weights summing
  // to 1, have the deviation of one.
  return std::sqrt(filterVariance(3) + 3.0 * kWeightVariance) / 255.0;
}

std::array<double, 4> valueDeviation(const TilingReference& reference, const SyntheticMap& map,
                                     const TilingReference::Sample& sample, double contrast) {
  constexpr double kStep = 1.0 / 255.0;
  std::array<double, 4> variance{};
  for (std::size_t k = 0; k < 4; ++k) {
    if (k >= std::size_t(map.dimensions) && k < 3)
      continue;
    std::array<double, 4> low = sample.gaussian;
    low[3] = sample.loss;
    std::array<double, 4> high = low;
    low[k] = k == 3 ? std::max(0.0, low[k] - kStep) : low[k] - kStep;
    high[k] = k == 3 ? std::min(1.0, high[k] + kStep) : high[k] + kStep;
    const auto below = reference.decoded(low, low[3], sample.here, contrast);
    const auto above = reference.decoded(high, high[3], sample.here, contrast);
    const double deviation = fetchDeviation() * (k == 3 ? 1.0 : contrast);
    for (std::size_t c = 0; c < 3; ++c)
      variance[c] += std::pow(deviation * (above[c] - below[c]) / (high[k] - low[k]), 2.0);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const bool isRoot = map.dimensions == 3; // the square of what is fetched
    if (map.table == SyntheticTable::joint && map.dimensions != 2)
      variance[c] += std::pow(tableDeviation(), 2.0) * (isRoot ? 4.0 * sample.value[c] : 1.0);
    variance[c] = std::sqrt(variance[c]);
  }
  return variance;
}

} // namespace lichen::test
