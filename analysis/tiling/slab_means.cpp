// SPDX-License-Identifier: MIT
// Slabs, Gaussian image -> slabs whose means over the shader's fetches equal the exemplar's.
#include "slab_means.h"

#include "prefilter.h"
#include "random_blend.h"
#include "table_lookup.h"

#include <lichen/lattice.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lichen::tiling {
namespace {

/// Blended fetches per slab mean. Independent values of standard deviation 0.3 would give it a
/// standard error of 0.0012; one tap of each is stratified over the image, which lowers that.
constexpr std::uint32_t kSamples = 1u << 16u;

/// A level of detail between two mip levels: the fetch is `rest` mip + (1 - rest) (mip + 1).
struct Between {
  std::size_t mip = 0;
  float rest = 1.0f;
};

/// The level of detail at which fetches lose `level` of the variance: 1 - level = above +
/// rest^2 (below - above), since a mip level's average is the next one.
Between betweenMips(double level, const std::vector<exemplar::ChannelMatrix>& lost) {
  std::size_t mip = 0;
  while (mip + 2 < lost.size() && scalarLoss(lost[mip + 1]) < level)
    ++mip;
  const double below = 1.0 - scalarLoss(lost[mip]);
  const double above = 1.0 - scalarLoss(lost[std::min(mip + 1, lost.size() - 1)]);
  if (below <= above)
    return {mip, 1.0f};
  return {mip, float(std::sqrt(std::clamp((1.0 - level - above) / (below - above), 0.0, 1.0)))};
}

/// The mip levels of the stored image as the shader reads them.
class Mips {
public:
  explicit Mips(const Table& gaussian)
      : width_(gaussian.width), height_(gaussian.height),
        stride_(std::size_t(channelCount(gaussian.format))) {
    for (std::uint32_t mip = 0; mip < gaussian.mipLevels; ++mip)
      levels_.push_back(decodeLevel(gaussian, mip));
  }

  [[nodiscard]] std::uint32_t texelCount(std::size_t mip) const {
    return std::uint32_t(levels_[mip].size() / stride_);
  }

  /// Blends a texel of the mip level with the texel of the next level that averages it; relative to
  /// mean 1/2.
  [[nodiscard]] std::array<float, 3> fetch(const Between& between, std::uint32_t texel) const {
    const std::size_t mip = between.mip;
    const std::size_t next = std::min(mip + 1, levels_.size() - 1);
    const std::size_t width = side(width_, mip);
    const std::size_t column = std::min(texel % width / 2, side(width_, next) - 1);
    const std::size_t row = std::min(texel / width / 2, side(height_, next) - 1);
    const float* fine = &levels_[mip][texel * stride_];
    const float* coarse = &levels_[next][(row * side(width_, next) + column) * stride_];
    std::array<float, 3> value{};
    for (std::size_t c = 0; c < std::min<std::size_t>(stride_, 3); ++c)
      value[c] = between.rest * fine[c] + (1.0f - between.rest) * coarse[c] - 0.5f;
    return value;
  }

private:
  static std::size_t side(std::uint32_t size, std::size_t mip) {
    return std::max<std::size_t>(1, size >> mip);
  }

  std::uint32_t width_;
  std::uint32_t height_;
  std::size_t stride_;
  std::vector<std::vector<float>> levels_;
};

/// A blend of three random texels.
std::array<float, 3> blendedFetch(const Mips& mips, const Between& between, std::uint32_t sample) {
  const std::uint32_t count = mips.texelCount(between.mip);
  const std::array<std::uint32_t, 3> tap = pcg3d({sample, 0u, 0u});
  const std::array<std::uint32_t, 3> place = pcg3d({sample, 1u, 0u});
  const std::array<float, 3> weights = randomBlendWeights(place[0], place[1]);
  const std::array<std::uint32_t, 3> texels{std::uint32_t(std::uint64_t(sample) * count / kSamples),
                                            tap[1] % count, tap[2] % count};
  std::array<float, 3> value{0.5f, 0.5f, 0.5f};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<float, 3> tapValue = mips.fetch(between, texels[k]);
    for (std::size_t c = 0; c < 3; ++c)
      value[c] += weights[k] * tapValue[c];
  }
  return value;
}

template <std::size_t kDimensions>
FetchMoments momentsOfFetches(const InverseTable& slab, const Mips& mips, const Between& between) {
  const TableLookup<kDimensions> lookup(slab);
  FetchMoments moments;
  for (std::uint32_t sample = 0; sample < kSamples; ++sample) {
    const TableValue value = lookup(blendedFetch(mips, between, sample));
    for (std::size_t c = 0; c < 4; ++c) {
      moments.mean[c] += double(value[c]) / kSamples;
      moments.square[c] += double(value[c]) * double(value[c]) / kSamples;
    }
  }
  return moments;
}

FetchMoments momentsOf(const InverseTable& slab, const Mips& mips, const Between& between) {
  switch (slab.dimensions) {
  case 1:
    return momentsOfFetches<1>(slab, mips, between);
  case 2:
    return momentsOfFetches<2>(slab, mips, between);
  default:
    return momentsOfFetches<3>(slab, mips, between);
  }
}

} // namespace

FetchMoments fetchMoments(const InverseTable& slab, const Table& gaussian, double level,
                          const std::vector<exemplar::ChannelMatrix>& lost) {
  return momentsOf(slab, Mips(gaussian), betweenMips(level, lost));
}

void restoreSlabMeans(std::vector<InverseTable>& slabs, const Table& gaussian,
                      const std::vector<exemplar::ChannelMatrix>& lost) {
  const Mips mips(gaussian);
  const InverseTable& exact = slabs.front();
  const std::vector<float>& mean = slabs.back().values;
  const std::vector<double> levels = tableLevels();
  const auto channels = std::size_t(exact.channels);
  tbb::parallel_for(std::size_t(1), slabs.size() - 1, [&](std::size_t k) {
    InverseTable& slab = slabs[k];
    const std::array<double, 4> fetched = momentsOf(slab, mips, betweenMips(levels[k], lost)).mean;
    for (std::size_t c = 0; c < channels; ++c) {
      float low = exact.values[c];
      float high = low;
      for (std::size_t i = c; i < exact.values.size(); i += channels) {
        low = std::min(low, exact.values[i]);
        high = std::max(high, exact.values[i]);
      }
      const auto shift = float(double(mean[c]) - fetched[c]);
      for (std::size_t i = c; i < slab.values.size(); i += channels)
        slab.values[i] = std::clamp(slab.values[i] + shift, low, high);
    }
  });
}

} // namespace lichen::tiling
