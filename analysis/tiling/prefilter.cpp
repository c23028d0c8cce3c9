// SPDX-License-Identifier: MIT
// One inverse table -> kTableLevels tables, each averaged over what a fetch has lost.
#include "prefilter.h"

#include "table_lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::tiling {
namespace {

/// Points of the Gaussian in each pass, for tables of 1, 2, 3 dimensions. Passes multiply: three of
/// 8 average 512 places. Against 4096 samples in one pass, on the generated rust of 256 x 256 a
/// cell is off by 0.6 to 1.1 codes of 8 bits (root mean square, by slab; at worst 4), as with 64
/// samples in one pass, which take three times as long.
constexpr std::array<std::size_t, 3> kPointsPerPass{64, 16, 8};

/// The loss matrix whose scalar is `level`, between nothing lost, the mips' and everything lost.
ChannelMatrix lossAt(double level, const std::vector<ChannelMatrix>& lost) {
  const auto n = lost.front().rows();
  ChannelMatrix below = ChannelMatrix::Zero(n, n);
  double scalarBelow = 0.0;
  const auto between = [&](const ChannelMatrix& above, double scalarAbove) -> ChannelMatrix {
    const double t = (level - scalarBelow) / (scalarAbove - scalarBelow);
    return below + t * (above - below);
  };
  for (const ChannelMatrix& mip : lost) {
    const double scalar = scalarLoss(mip);
    if (scalar <= scalarBelow)
      continue;
    if (level <= scalar)
      return between(mip, scalar);
    below = mip;
    scalarBelow = scalar;
  }
  return scalarBelow < 1.0 ? between(ChannelMatrix::Identity(n, n), 1.0) : below;
}

/// One pass of a blur: displacements along a line.
using Displacements = std::vector<std::array<float, 3>>;

/// A Gaussian blur with the covariance `loss` / 36 as one pass for each column l of the factor L of
/// loss = L diag(d) L^T: displacements l z with z ~ N(0, d / 36).
std::vector<Displacements> passes(ChannelMatrix loss) {
  const auto n = loss.rows();
  std::vector<Displacements> result;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double variance = loss(k, k);
    if (variance <= 0.0) // the matrix is positive semidefinite: so is the whole column
      continue;
    const ChannelVector direction = loss.col(k) / variance;
    loss -= variance * direction * direction.transpose();
    Displacements displacements;
    for (const Point& p :
         stratifiedGaussian(kPointsPerPass[std::size_t(n - 1)], 1, Precision::bits16)) {
      const double along = std::sqrt(variance) * (double(p.x) - kGaussianMean);
      std::array<float, 3> displacement{};
      for (Eigen::Index c = k; c < n; ++c)
        displacement[std::size_t(c)] = float(along * direction[c]);
      displacements.push_back(displacement);
    }
    result.push_back(std::move(displacements));
  }
  return result;
}

std::array<float, 3> sum(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// Each cell's mean over what stands at its middle, displaced.
template <std::size_t kDimensions>
InverseTable averaged(const InverseTable& table, const Displacements& displacements) {
  const TableLookup<kDimensions> lookup(table);
  const auto side = std::size_t(table.side);
  const auto channels = std::size_t(table.channels);
  std::vector<float> middles;
  for (std::size_t k = 0; k < side; ++k)
    middles.push_back(float(gaussianQuantile((double(k) + 0.5) / double(side))));
  InverseTable result = table;
  tbb::parallel_for(std::size_t(0), table.cellCount(), [&](std::size_t cell) {
    std::array<float, 3> middle{};
    std::size_t rest = cell;
    for (std::size_t axis = 0; axis < kDimensions; ++axis, rest /= side)
      middle[axis] = middles[rest % side];
    std::array<float, 4> total{};
    for (const std::array<float, 3>& displacement : displacements) {
      const std::array<float, 4> value = lookup(sum(middle, displacement));
      for (std::size_t c = 0; c < 4; ++c)
        total[c] += value[c];
    }
    for (std::size_t c = 0; c < channels; ++c)
      result.values[cell * channels + c] = total[c] / float(displacements.size());
  });
  return result;
}

template <std::size_t kDimensions>
InverseTable blurred(InverseTable table, const ChannelMatrix& loss) {
  for (const Displacements& displacements : passes(loss))
    table = averaged<kDimensions>(table, displacements);
  return table;
}

template <std::size_t kDimensions>
std::vector<InverseTable> slabsOf(const InverseTable& table,
                                  const std::vector<ChannelMatrix>& lost) {
  const Moments moments = interpolatedMoments(table);
  std::vector<InverseTable> slabs{table};
  const std::vector<double> levels = tableLevels();
  for (std::size_t k = 1; k + 1 < levels.size(); ++k)
    slabs.push_back(blurred<kDimensions>(table, lossAt(levels[k], lost)));
  slabs.push_back(table);
  const auto channels = std::size_t(table.channels);
  for (std::size_t i = 0; i < table.values.size(); ++i)
    slabs.back().values[i] = float(moments.mean[Eigen::Index(i % channels)]);
  return slabs;
}

TexelFormat tableFormat(std::size_t channels, ValueEncoding encoding, int bits) {
  const bool unorm =
      bits == 8 && (encoding == ValueEncoding::srgb || encoding == ValueEncoding::linear);
  if (channels == 1)
    return unorm ? TexelFormat::r8Unorm : TexelFormat::r16Sfloat;
  if (channels == 2)
    return unorm ? TexelFormat::rg8Unorm : TexelFormat::rg16Sfloat;
  if (unorm)
    return encoding == ValueEncoding::srgb ? TexelFormat::rgba8Srgb : TexelFormat::rgba8Unorm;
  return TexelFormat::rgba16Sfloat;
}

} // namespace

std::vector<double> tableLevels() {
  std::vector<double> levels;
  for (int k = 0; k < kTableLevels; ++k) {
    const double kept = 1.0 - double(k) / (kTableLevels - 1);
    levels.push_back(1.0 - kept * kept);
  }
  return levels;
}

std::vector<InverseTable> prefilteredSlabs(const InverseTable& table,
                                           const std::vector<ChannelMatrix>& lost) {
  switch (table.dimensions) {
  case 1:
    return slabsOf<1>(table, lost);
  case 2:
    return slabsOf<2>(table, lost);
  default:
    return slabsOf<3>(table, lost);
  }
}

Table inverseTableTexels(const std::vector<InverseTable>& slabs, ValueEncoding encoding, int bits) {
  const InverseTable& first = slabs.front();
  const auto side = std::uint32_t(first.side);
  const auto levels = std::uint32_t(slabs.size());
  Table table;
  table.format = tableFormat(std::size_t(first.channels), encoding, bits);
  table.width = side;
  table.height = first.dimensions == 1 ? levels : first.dimensions == 2 ? side * levels : side;
  table.depth = first.dimensions == 3 ? side * levels : 0;
  const auto texelChannels = std::size_t(channelCount(table.format));
  const auto channels = std::size_t(first.channels);
  std::vector<float> texels;
  for (const InverseTable& slab : slabs)
    for (std::size_t cell = 0; cell < slab.cellCount(); ++cell)
      for (std::size_t c = 0; c < texelChannels; ++c)
        texels.push_back(c < channels ? slab.values[cell * channels + c] : 1.0f);
  appendTexels(table.texels, table.format, texels);
  return table;
}

} // namespace lichen::tiling
