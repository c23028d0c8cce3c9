// SPDX-License-Identifier: MIT
// Seed and pixel -> random value.
//
// Sources: [GLM14] section 2.1 (counts), [W88] (deviates), [SLF14] (the bits of both).
#include "white_noise.h"

#include "gaussian_distribution.h"
#include "transport/random.h"

#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>

namespace lichen::gaussian {
namespace {

/// Larger means are split into parts, because a sum of Poisson variates is Poisson. exp(-32) is a
/// hundred times the resolution of the uniform number that is compared with it.
constexpr double kLargestPart = 32.0;

/// Returns the smallest count whose distribution function exceeds `u`.
int poissonQuantile(double mean, double u) {
  int count = 0;
  double probability = std::exp(-mean);
  double cumulated = probability;
  while (u >= cumulated) {
    ++count;
    probability *= mean / count;
    const double next = cumulated + probability;
    if (next == cumulated) // the tail, below the resolution
      break;
    cumulated = next;
  }
  return count;
}

/// Returns a unique number for each pixel of Z^2.
std::uint64_t pixelCounter(int x, int y) {
  return (std::uint64_t(std::uint32_t(y)) << 32u) | std::uint32_t(x);
}

/// Returns value(counter) for each pixel; rows run in parallel.
template <class Value>
std::vector<float> filled(const PixelDomain& domain, const Value& value) {
  assert(domain.width >= 1 && domain.height >= 1);
  const auto columns = std::size_t(domain.width);
  std::vector<float> field(columns * std::size_t(domain.height));
  tbb::parallel_for(0, domain.height, [&](int y) {
    for (int x = 0; x < domain.width; ++x)
      field[std::size_t(y) * columns + std::size_t(x)] =
          value(pixelCounter(domain.x + x, domain.y + y));
  });
  return field;
}

} // namespace

int poissonVariate(double mean, std::uint64_t seed, std::uint64_t counter) {
  assert(mean >= 0.0);
  const int parts = std::max(1, int(std::ceil(mean / kLargestPart)));
  int count = 0;
  for (int part = 0; part < parts; ++part)
    count += poissonQuantile(
        mean / parts,
        transport::randomUniform(transport::randomBits(seed, std::uint64_t(part)), counter));
  return count;
}

std::vector<float> poissonCounts(const PixelDomain& domain, double intensity, std::uint64_t seed) {
  return filled(domain, [&](std::uint64_t counter) {
    return float(poissonVariate(intensity, seed, counter));
  });
}

std::vector<float> gaussianWhiteNoise(const PixelDomain& domain, std::uint64_t seed) {
  return filled(domain, [&](std::uint64_t counter) {
    // Centres of 2^52 strata: never 0 or 1.
    const double u = (double(transport::randomBits(seed, counter) >> 12u) + 0.5) * 0x1.0p-52;
    return float((gaussianQuantile(u) - kGaussianMean) / kGaussianDeviation);
  });
}

} // namespace lichen::gaussian
