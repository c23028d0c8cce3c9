// SPDX-License-Identifier: MIT
// Levels of a table of slopes (n channels) -> levels with the variance of the slopes added (n + 1).
// Uses the law of total variance, conditional on the fetched Gaussian value: LEAN's moments [OB10]
// without its assumption that slopes are Gaussian.
#include "slope_variance.h"

#include "coarse_table.h"
#include "level_means.h"
#include "prefilter.h"
#include "table_lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace lichen::gaussianization {
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

} // namespace lichen::gaussianization
