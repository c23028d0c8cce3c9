// SPDX-License-Identifier: MIT
// Slabs of slopes (n channels) -> slabs with the variance of the slopes added (n + 1).
// Uses the law of total variance, conditional on the fetched Gaussian value: LEAN's moments [OB10]
// without its assumption that slopes are Gaussian.
#include "slope_variance.h"

#include "prefilter.h"
#include "slab_means.h"
#include "table_lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace lichen::tiling {
namespace {

/// Stratified samples for a cell's variance; exact for a linear table.
constexpr std::size_t kSamplesPerCell = 256;

/// The variance of each cell's slopes over the lost displacements, as the mean of the channels.
template <std::size_t kDimensions>
std::vector<float> sampledVariance(const InverseTable& table, const exemplar::ChannelMatrix& loss) {
  const std::vector<std::array<float, 3>> offsets = lossDisplacements(loss, kSamplesPerCell);
  const TableLookup<kDimensions> lookup(table);
  const std::vector<Point> middles = cellMiddles(table.dimensions, table.side);
  std::vector<float> result(table.cellCount());
  tbb::parallel_for(std::size_t(0), result.size(), [&](std::size_t cell) {
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
    result[cell] = float(std::max(0.0, variance / table.channels));
  });
  return result;
}

InverseTable appended(const InverseTable& slab, const std::vector<float>& channel) {
  InverseTable result{slab.dimensions, slab.side, slab.channels + 1, {}};
  result.values.reserve(channel.size() * std::size_t(result.channels));
  for (std::size_t cell = 0; cell < channel.size(); ++cell) {
    const auto first = slab.values.begin() + std::ptrdiff_t(cell) * slab.channels;
    result.values.insert(result.values.end(), first, first + slab.channels);
    result.values.push_back(channel[cell]);
  }
  return result;
}

/// Scales the last channel so that it and the variance of the others add up to `whole`.
void scaleToWhole(InverseTable& slab, const FetchMoments& fetched, double whole) {
  const auto slopes = std::size_t(slab.channels - 1);
  double shown = 0.0;
  for (std::size_t c = 0; c < slopes; ++c)
    shown += (fetched.square[c] - fetched.mean[c] * fetched.mean[c]) / double(slopes);
  const double hidden = fetched.mean[slopes];
  if (hidden <= 0.0)
    return;
  const auto scale = float(std::max(0.0, whole - shown) / hidden);
  for (std::size_t i = slopes; i < slab.values.size(); i += slopes + 1)
    slab.values[i] *= scale;
}

} // namespace

void appendSlopeVariance(std::vector<InverseTable>& slabs, const InverseTable& table,
                         const Table& gaussian, const std::vector<exemplar::ChannelMatrix>& lost) {
  const double whole = interpolatedMoments(table).covariance.trace() / double(table.channels);
  const std::vector<double> levels = tableLevels();
  const std::size_t cells = table.cellCount();
  slabs.front() = appended(slabs.front(), std::vector<float>(cells, 0.0f));
  slabs.back() = appended(slabs.back(), std::vector<float>(cells, float(whole)));
  for (std::size_t k = 1; k + 1 < slabs.size(); ++k) {
    const exemplar::ChannelMatrix loss = lossAt(levels[k], lost);
    slabs[k] = appended(slabs[k], table.dimensions == 1 ? sampledVariance<1>(table, loss)
                                                        : sampledVariance<2>(table, loss));
    scaleToWhole(slabs[k], fetchMoments(slabs[k], gaussian, levels[k], lost), whole);
  }
}

} // namespace lichen::tiling
