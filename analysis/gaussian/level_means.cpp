// SPDX-License-Identifier: MIT
// Levels of a table, Gaussian image -> levels whose means over the shader's fetches equal the
// exemplar's.
#include "level_means.h"

#include "prefilter.h"
#include "table_lookup.h"

#include <lichen/gaussian_image.h>
#include <lichen/lattice.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lichen::gaussian {
namespace {

/// Blended fetches per mean. Independent values of standard deviation 0.3 would give it a standard
/// error of 0.0012; one tap of each is spread evenly over the image, which lowers that.
constexpr std::uint32_t kSamples = 1u << 16u;

/// The level of detail at which fetches lose `loss`, and the factor that gives their values about
/// the mean the deviation of that loss: 1 unless all fetches lose more.
struct FetchLevel {
  float lod = 0.0f;
  float scale = 1.0f;
};

FetchLevel fetchLevelOf(float loss, const std::vector<float>& losses) {
  const float least = losses.front();
  if (loss <= least)
    return {0.0f, least < 1.0f ? std::sqrt((1.0f - loss) / (1.0f - least)) : 1.0f};
  for (std::size_t mip = 1; mip < losses.size(); ++mip)
    if (loss < losses[mip])
      return {float(mip - 1) + (loss - losses[mip - 1]) / (losses[mip] - losses[mip - 1]), 1.0f};
  return {float(losses.size() - 1), 1.0f};
}

/// A blend of fetches at three positions, two of them random.
std::array<float, 3> blendedFetch(const RepeatingImage& image, const FetchLevel& at,
                                  std::uint32_t sample) {
  const auto unit = [](std::uint32_t hash) { return float(hash >> 8u) * 0x1.0p-24f; };
  const std::array<std::uint32_t, 3> x = pcg3d({sample, 0u, 0u});
  const std::array<std::uint32_t, 3> y = pcg3d({sample, 1u, 0u});
  const std::array<float, 3> weights = randomBlendWeights(x[2], y[2]);
  const std::array<std::array<float, 2>, 3> taps{
      {spreadPosition(sample, kSamples), {unit(x[0]), unit(y[0])}, {unit(x[1]), unit(y[1])}}};
  std::array<float, 3> value{0.5f, 0.5f, 0.5f};
  for (std::size_t k = 0; k < 3; ++k) {
    const RepeatingImage::Value tap = image.at(taps[k][0], taps[k][1], at.lod);
    for (std::size_t c = 0; c < 3; ++c)
      value[c] += weights[k] * at.scale * (tap[c] - kStoredGaussianMean);
  }
  return value;
}

template <std::size_t kDimensions>
FetchMoments momentsOfFetches(const InverseTable& table, const RepeatingImage& image,
                              const FetchLevel& at) {
  const TableLookup<kDimensions> lookup(table);
  FetchMoments moments;
  for (std::uint32_t sample = 0; sample < kSamples; ++sample) {
    const TableValue value = lookup(blendedFetch(image, at, sample));
    for (std::size_t c = 0; c < 4; ++c) {
      moments.mean[c] += double(value[c]) / kSamples;
      moments.square[c] += double(value[c]) * double(value[c]) / kSamples;
    }
  }
  return moments;
}

/// The part of the variance of the last level's roots, at its own distance, that counts for their
/// mean light: distant fetches lose more, until they all decode to one colour. The error of the
/// mean is then half that variance at both ends.
constexpr double kShownOfLast = 0.5;

/// What is added to values with this mean and variance so that they, or their squares, have the
/// mean `wanted`.
double shiftTo(double wanted, double mean, double variance, bool isRoot) {
  // E[(v + d)^2] = (E[v] + d)^2 + Var v.
  return (isRoot ? std::sqrt(std::max(0.0, wanted - variance)) : wanted) - mean;
}

} // namespace

FetchMoments fetchMoments(const InverseTable& table, int level, const RepeatingImage& gaussian,
                          const std::vector<float>& losses) {
  const FetchLevel at = fetchLevelOf(float(levelLoss(level)), losses);
  switch (table.dimensions) {
  case 1:
    return momentsOfFetches<1>(table, gaussian, at);
  case 2:
    return momentsOfFetches<2>(table, gaussian, at);
  default:
    return momentsOfFetches<3>(table, gaussian, at);
  }
}

void restoreLevelMeans(std::vector<InverseTable>& levels, bool holdsRoots, const Table& gaussian,
                       const std::vector<float>& losses) {
  const RepeatingImage image(gaussian);
  const InverseTable& exact = levels.front();
  const exemplar::Moments wanted = interpolatedMoments(exact);
  const auto channels = std::size_t(exact.channels);
  tbb::parallel_for(std::size_t(1), levels.size(), [&](std::size_t k) {
    InverseTable& level = levels[k];
    const FetchMoments fetched = fetchMoments(level, int(k), image, losses);
    for (std::size_t c = 0; c < channels; ++c) {
      const auto [low, high] = exemplar::rangeOf(exact.values, channels, c);
      const auto channel = Eigen::Index(c);
      const double mean = wanted.mean[channel];
      const double target = holdsRoots ? wanted.covariance(channel, channel) + mean * mean : mean;
      const double variance = fetched.square[c] - fetched.mean[c] * fetched.mean[c];
      const double shown = k + 1 < levels.size() ? variance : kShownOfLast * variance;
      const auto shift = float(shiftTo(target, fetched.mean[c], shown, holdsRoots));
      for (std::size_t i = c; i < level.values.size(); i += channels)
        level.values[i] = std::clamp(level.values[i] + shift, low, high);
    }
  });
}

// Levels of a table of slopes (n channels) -> levels with the variance of the slopes added (n + 1).
// Uses the law of total variance, conditional on the fetched Gaussian value: LEAN's moments [OB10]
// without its assumption that slopes are Gaussian.
namespace {

/// Stratified samples for a cell's variance; exact for a linear table.
constexpr std::size_t kSamplesPerCell = 256;

/// The variance of each cell's slopes over the lost displacements, as the mean of the channels.
template <std::size_t kDimensions>
InverseTable sampledVariance(const InverseTable& table, const exemplar::ChannelMatrix& loss) {
  const std::vector<std::array<float, 3>> offsets = lossDisplacements(loss, kSamplesPerCell);
  const TableLookup<kDimensions> lookup(table);
  const std::vector<Point> middles = cellMiddles(table.dimensions, table.side);
  InverseTable result{table.dimensions, table.side, 1, std::vector<float>(table.cellCount())};
  tbb::parallel_for(std::size_t(0), table.cellCount(), [&](std::size_t cell) {
    std::array<double, 4> sum{};
    std::array<double, 4> squares{};
    for (const std::array<float, 3>& offset : offsets) {
      const Point& middle = middles[cell];
      const TableValue value =
          lookup({middle.x + offset[0], middle.y + offset[1], middle.z + offset[2]});
      for (std::size_t c = 0; c < 4; ++c) {
        sum[c] += double(value[c]);
        squares[c] += double(value[c]) * double(value[c]);
      }
    }
    constexpr double kCount = kSamplesPerCell;
    double variance = 0.0;
    for (std::size_t c = 0; c < std::size_t(table.channels); ++c)
      variance += squares[c] / kCount - sum[c] / kCount * (sum[c] / kCount);
    result.values[cell] = float(std::max(0.0, variance / table.channels));
  });
  return result;
}

InverseTable appended(const InverseTable& level, const std::vector<float>& channel) {
  InverseTable result{level.dimensions, level.side, level.channels + 1, {}};
  result.values.reserve(channel.size() * std::size_t(result.channels));
  for (std::size_t cell = 0; cell < channel.size(); ++cell) {
    const auto first = level.values.begin() + std::ptrdiff_t(cell) * level.channels;
    result.values.insert(result.values.end(), first, first + level.channels);
    result.values.push_back(channel[cell]);
  }
  return result;
}

/// Scales the last channel so that it and the variance of the others add up to `whole`.
void scaleToWhole(InverseTable& level, const FetchMoments& fetched, double whole) {
  const auto slopes = std::size_t(level.channels - 1);
  double shown = 0.0;
  for (std::size_t c = 0; c < slopes; ++c)
    shown += (fetched.square[c] - fetched.mean[c] * fetched.mean[c]) / double(slopes);
  const double hidden = fetched.mean[slopes];
  if (hidden <= 0.0)
    return;
  const auto scale = float(std::max(0.0, whole - shown) / hidden);
  for (std::size_t i = slopes; i < level.values.size(); i += slopes + 1)
    level.values[i] *= scale;
}

} // namespace

void appendSlopeVariance(std::vector<InverseTable>& levels, const InverseTable& table,
                         const Table& gaussian, const std::vector<exemplar::ChannelMatrix>& lost,
                         const std::vector<float>& losses) {
  const double whole = interpolatedMoments(table).covariance.trace() / double(table.channels);
  const RepeatingImage image(gaussian);
  levels.front() = appended(levels.front(), std::vector<float>(table.cellCount(), 0.0f));
  tbb::parallel_for(1, int(levels.size()), [&](int k) {
    InverseTable& level = levels[std::size_t(k)];
    const exemplar::ChannelMatrix loss = lossAt(levelLoss(k), lost);
    const InverseTable fine =
        table.dimensions == 1 ? sampledVariance<1>(table, loss) : sampledVariance<2>(table, loss);
    InverseTable variance = coarser(fine, level.side, retainedAmplitude(k));
    for (float& value : variance.values)
      value = std::max(value, 0.0f);
    level = appended(level, variance.values);
    scaleToWhole(level, fetchMoments(level, k, image, losses), whole);
  });
}

} // namespace lichen::gaussian
