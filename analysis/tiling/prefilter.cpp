// SPDX-License-Identifier: MIT
// One inverse table -> kTableLevels tables, each averaged over what a fetch has lost.
#include "prefilter.h"

#include "transport/covariance_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lichen::tiling {
namespace {

/// Gaussian samples for each cell's average, and for the mean of a whole slab. The stratified sets
/// are whitened, so a linear table is averaged exactly whatever their number.
constexpr std::size_t kSamplesPerCell = 64;
constexpr std::size_t kSamplesPerMean = 4096;

/// Cell coordinate of a Gaussian value, side * U - 1/2, tabulated: evaluated some 10^7 times.
class CellCoordinate {
public:
  explicit CellCoordinate(int side) {
    for (int k = 0; k <= kSteps + 1; ++k)
      values_[std::size_t(k)] = float(side * gaussianCdf(kLow + k * (kHigh - kLow) / kSteps) - 0.5);
  }
  [[nodiscard]] float operator()(float gaussian) const {
    const float place =
        std::clamp((gaussian - float(kLow)) * float(kSteps / (kHigh - kLow)), 0.0f, float(kSteps));
    const auto index = std::size_t(place);
    return values_[index] + (place - float(index)) * (values_[index + 1] - values_[index]);
  }

private:
  static constexpr int kSteps = 4096;
  static constexpr double kLow = -0.5; // six deviations each way
  static constexpr double kHigh = 1.5;
  std::array<float, kSteps + 2> values_{};
};

/// The table with its cells padded to four channels, for lookups at Gaussian values.
template <std::size_t kDimensions>
class Lookup {
public:
  explicit Lookup(const InverseTable& table)
      : side_(std::size_t(table.side)), coordinate_(table.side), cells_(table.cellCount()) {
    for (std::size_t i = 0; i < cells_.size(); ++i)
      for (std::size_t c = 0; c < std::size_t(table.channels); ++c)
        cells_[i][c] = table.values[i * std::size_t(table.channels) + c];
  }

  using Value = std::array<float, 4>;

  [[nodiscard]] Value operator()(const std::array<float, 3>& gaussian) const {
    std::size_t base = 0;
    std::array<std::size_t, kDimensions> step{};
    std::array<float, kDimensions> fraction{};
    std::size_t stride = 1;
    for (std::size_t axis = 0; axis < kDimensions; ++axis, stride *= side_) {
      const float place = std::clamp(coordinate_(gaussian[axis]), 0.0f, float(side_ - 1));
      const auto cell = std::size_t(place);
      base += cell * stride;
      step[axis] = cell + 1 < side_ ? stride : 0;
      fraction[axis] = place - float(cell);
    }
    return interpolated<kDimensions>(&cells_[base], step, fraction);
  }

private:
  template <std::size_t kAxes>
  static Value interpolated(const Value* cell, const std::array<std::size_t, kDimensions>& step,
                            const std::array<float, kDimensions>& fraction) {
    if constexpr (kAxes == 0) {
      return *cell;
    } else {
      const Value low = interpolated<kAxes - 1>(cell, step, fraction);
      const Value high = interpolated<kAxes - 1>(cell + step[kAxes - 1], step, fraction);
      Value result;
      for (std::size_t c = 0; c < 4; ++c)
        result[c] = low[c] + fraction[kAxes - 1] * (high[c] - low[c]);
      return result;
    }
  }

  std::size_t side_;
  CellCoordinate coordinate_;
  std::vector<Value> cells_;
};

/// The loss matrix whose scalar is `level`, between nothing lost, the mips' and everything lost.
ChannelMatrix lossAt(double level, const LostVariance& lost) {
  const auto n = lost.perMip.front().rows();
  ChannelMatrix below = ChannelMatrix::Zero(n, n);
  double scalarBelow = 0.0;
  const auto between = [&](const ChannelMatrix& above, double scalarAbove) -> ChannelMatrix {
    const double t = (level - scalarBelow) / (scalarAbove - scalarBelow);
    return below + t * (above - below);
  };
  for (const ChannelMatrix& mip : lost.perMip) {
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

/// Zero-mean Gaussian displacements with the covariance `loss` / 36.
std::vector<std::array<float, 3>> displacements(const ChannelMatrix& loss, std::size_t count) {
  const auto n = int(loss.rows());
  const ChannelMatrix root = transport::power(loss, 0.5);
  std::vector<std::array<float, 3>> result;
  for (const Point& p : stratifiedGaussian(count, n, Precision::bits16)) {
    const std::array<float, 3> raw{p.x, p.y, p.z};
    ChannelVector centred(n);
    for (int c = 0; c < n; ++c)
      centred[c] = double(raw[std::size_t(c)]) - kGaussianMean;
    const ChannelVector moved = root * centred;
    std::array<float, 3> displacement{};
    for (int c = 0; c < n; ++c)
      displacement[std::size_t(c)] = float(moved[c]);
    result.push_back(displacement);
  }
  return result;
}

std::array<float, 3> sum(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <std::size_t kDimensions>
InverseTable averaged(const InverseTable& table, const Lookup<kDimensions>& lookup,
                      const ChannelMatrix& loss) {
  const std::vector<std::array<float, 3>> offsets = displacements(loss, kSamplesPerCell);
  InverseTable result = table;
  const auto side = std::size_t(table.side);
  const auto channels = std::size_t(table.channels);
  tbb::parallel_for(std::size_t(0), table.cellCount(), [&](std::size_t cell) {
    std::array<float, 3> middle{};
    std::size_t rest = cell;
    for (std::size_t axis = 0; axis < std::size_t(table.dimensions); ++axis, rest /= side)
      middle[axis] = float(gaussianQuantile((double(rest % side) + 0.5) / double(side)));
    std::array<float, 4> total{};
    for (const std::array<float, 3>& offset : offsets) {
      const std::array<float, 4> value = lookup(sum(middle, offset));
      for (std::size_t c = 0; c < 4; ++c)
        total[c] += value[c];
    }
    for (std::size_t c = 0; c < channels; ++c)
      result.values[cell * channels + c] = total[c] / float(offsets.size());
  });
  return result;
}

/// Shifts the slab so that its lookups average to `mean` over the Gaussian values that remain
/// after `loss`; interpolating a curved table errs a little. Stays in the range of `table`.
template <std::size_t kDimensions>
void restoreMean(InverseTable& slab, const InverseTable& table, const ChannelMatrix& loss,
                 const ChannelVector& mean) {
  const auto n = loss.rows();
  const Lookup<kDimensions> lookup(slab);
  const std::array<float, 3> middle{float(kGaussianMean), float(kGaussianMean),
                                    float(kGaussianMean)};
  std::array<double, 4> total{};
  for (const std::array<float, 3>& offset :
       displacements(ChannelMatrix::Identity(n, n) - loss, kSamplesPerMean)) {
    const std::array<float, 4> value = lookup(sum(middle, offset));
    for (std::size_t c = 0; c < 4; ++c)
      total[c] += double(value[c]);
  }
  const auto channels = std::size_t(table.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    float low = table.values[c];
    float high = low;
    for (std::size_t i = c; i < table.values.size(); i += channels) {
      low = std::min(low, table.values[i]);
      high = std::max(high, table.values[i]);
    }
    const auto shift = float(mean[Eigen::Index(c)] - total[c] / double(kSamplesPerMean));
    for (std::size_t i = c; i < slab.values.size(); i += channels)
      slab.values[i] = std::clamp(slab.values[i] + shift, low, high);
  }
}

template <std::size_t kDimensions>
std::vector<InverseTable> slabsOf(const InverseTable& table, const LostVariance& lost) {
  const Moments moments = interpolatedMoments(table);
  const Lookup<kDimensions> lookup(table);
  std::vector<InverseTable> slabs{table};
  const std::vector<double> levels = tableLevels();
  for (std::size_t k = 1; k + 1 < levels.size(); ++k) {
    const ChannelMatrix loss = lossAt(levels[k], lost);
    slabs.push_back(averaged(table, lookup, loss));
    restoreMean<kDimensions>(slabs.back(), table, loss, moments.mean);
  }
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

std::vector<InverseTable> prefilteredSlabs(const InverseTable& table, const LostVariance& lost) {
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
