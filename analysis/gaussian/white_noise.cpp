// SPDX-License-Identifier: MIT
// Seed and pixel -> random value.
//
// Sources: [W88] (deviates), [SLF14] (their bits).
#include "white_noise.h"

#include "gaussian_distribution.h"
#include "transport/random.h"

#include <tbb/parallel_for.h>

#include <cassert>

namespace lichen::gaussian {
namespace {

/// Returns a unique number for each pixel of Z^2.
std::uint64_t pixelCounter(int x, int y) {
  return (std::uint64_t(std::uint32_t(y)) << 32u) | std::uint32_t(x);
}

} // namespace

std::vector<float> gaussianWhiteNoise(const PixelDomain& domain, std::uint64_t seed) {
  assert(domain.width >= 1 && domain.height >= 1);
  const auto columns = std::size_t(domain.width);
  std::vector<float> field(columns * std::size_t(domain.height));
  tbb::parallel_for(0, domain.height, [&](int y) {
    for (int x = 0; x < domain.width; ++x) {
      const std::uint64_t counter = pixelCounter(domain.x + x, domain.y + y);
      // Centres of 2^52 strata: never 0 or 1.
      const double u = (double(transport::randomBits(seed, counter) >> 12u) + 0.5) * 0x1.0p-52;
      field[std::size_t(y) * columns + std::size_t(x)] =
          float((gaussianQuantile(u) - kGaussianMean) / kGaussianDeviation);
    }
  });
  return field;
}

} // namespace lichen::gaussian
