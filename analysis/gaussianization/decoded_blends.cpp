// SPDX-License-Identifier: MIT
// Gaussian image (width * height points) and table -> blends (D, and channels, by 2^18).
#include "decoded_blends.h"

#include "random_blend.h"
#include "table_lookup.h"

#include <lichen/lattice.h>

#include <tbb/parallel_for.h>

#include <array>
#include <cstdint>

namespace lichen::gaussianization {
namespace {

/// The quantity measured on blends has about a fifth of the values' standard deviation on
/// photographs, so the correlations found have standard errors of 4e-4.
constexpr std::uint32_t kBlends = 1u << 18u;
constexpr std::uint32_t kBlendsOfBlock = 1u << 12u;

/// The pixel at a position with coordinates in [0, 2^32).
const Point& pixelAt(const Gaussianized& gaussian, std::uint32_t x, std::uint32_t y) {
  const auto column = std::size_t((std::uint64_t(x) * std::uint64_t(gaussian.width)) >> 32u);
  const auto row = std::size_t((std::uint64_t(y) * std::uint64_t(gaussian.height)) >> 32u);
  return gaussian.image[row * std::size_t(gaussian.width) + column];
}

std::array<float, 3> randomBlend(const Gaussianized& gaussian, std::uint32_t sample) {
  constexpr auto kMean = float(gaussian::kGaussianMean);
  const std::array<std::uint32_t, 3> x = pcg3d({sample, 0u, 0u});
  const std::array<std::uint32_t, 3> y = pcg3d({sample, 1u, 0u});
  const std::array<std::uint32_t, 3> place = pcg3d({sample, 2u, 0u});
  const std::array<float, 3> weights = randomBlendWeights(place[0], place[1]);
  std::array<float, 3> g{kMean, kMean, kMean};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& p = pixelAt(gaussian, x[k], y[k]);
    g[0] += weights[k] * (p.x - kMean);
    g[1] += weights[k] * (p.y - kMean);
    g[2] += weights[k] * (p.z - kMean);
  }
  return g;
}

template <std::size_t kDimensions>
DecodedBlends blendsThrough(const Gaussianized& gaussian, const InverseTable& table) {
  const TableLookup<kDimensions> lookup(table);
  DecodedBlends blends{Eigen::MatrixXf(gaussian.dimensions, kBlends),
                       Eigen::MatrixXf(table.channels, kBlends)};
  tbb::parallel_for(0u, kBlends / kBlendsOfBlock, [&](std::uint32_t block) {
    for (std::uint32_t k = 0; k < kBlendsOfBlock; ++k) {
      const std::uint32_t sample = block * kBlendsOfBlock + k;
      const std::array<float, 3> g = randomBlend(gaussian, sample);
      const auto value = lookup(g);
      for (Eigen::Index d = 0; d < blends.gaussian.rows(); ++d)
        blends.gaussian(d, sample) = (g[std::size_t(d)] - float(gaussian::kGaussianMean)) /
                                     float(gaussian::kGaussianDeviation);
      for (Eigen::Index c = 0; c < blends.values.rows(); ++c)
        blends.values(c, sample) = value[std::size_t(c)];
    }
  });
  return blends;
}

} // namespace

DecodedBlends decodedBlends(const Gaussianized& gaussian, const InverseTable& table) {
  if (table.dimensions == 1)
    return blendsThrough<1>(gaussian, table);
  if (table.dimensions == 2)
    return blendsThrough<2>(gaussian, table);
  return blendsThrough<3>(gaussian, table);
}

} // namespace lichen::gaussianization
