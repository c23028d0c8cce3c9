// SPDX-License-Identifier: MIT
// Pairs of Gaussian point and value, one per pixel -> table of side^D cells.
#include "inverse_table.h"

#include "transport/covariance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace lichen::gaussian {
namespace {

using transport::TransportOptions;

std::size_t power(int base, int exponent) {
  std::size_t result = 1;
  for (int k = 0; k < exponent; ++k)
    result *= std::size_t(base);
  return result;
}

/// Applies side * M along one axis. M_ij is the integral of the product of two cells' interpolation
/// weights: 2/3 on the diagonal (5/6 at the ends, which are constant beyond their centre) and 1/6
/// beside it.
std::vector<double> applyMass(const std::vector<double>& values, int side, std::size_t stride) {
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto place = int(i / stride % std::size_t(side));
    const double before = place > 0 ? values[i - stride] : values[i];
    const double after = place + 1 < side ? values[i + stride] : values[i];
    result[i] = (before + 4.0 * values[i] + after) / 6.0;
  }
  return result;
}

/// Shifts and scales the table so that lookups have the wanted moments, within the range of the
/// values that it was fitted to. Clamping disturbs the moments slightly, so the step is repeated.
void matchMoments(InverseTable& table, std::span<const float> decoded) {
  constexpr int kPasses = 4;
  const auto channels = std::size_t(table.channels);
  const exemplar::Moments wanted = exemplar::momentsOf(decoded, table.channels);
  std::array<float, exemplar::kMaxChannels> low{};
  std::array<float, exemplar::kMaxChannels> high{};
  for (std::size_t c = 0; c < channels; ++c) {
    const auto [least, most] = exemplar::rangeOf(decoded, channels, c);
    low[c] = least;
    high[c] = most;
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    const exemplar::Moments found = interpolatedMoments(table);
    const exemplar::ChannelMatrix map =
        transport::covarianceMap(found.covariance, wanted.covariance);
    for (std::size_t i = 0; i < table.values.size(); i += channels) {
      exemplar::ChannelVector d(table.channels);
      for (std::size_t c = 0; c < channels; ++c)
        d[Eigen::Index(c)] = double(table.values[i + c]) - found.mean[Eigen::Index(c)];
      const exemplar::ChannelVector moved = wanted.mean + map * d;
      for (std::size_t c = 0; c < channels; ++c)
        table.values[i + c] = std::clamp(float(moved[Eigen::Index(c)]), low[c], high[c]);
    }
  }
}

/// Pixel indices ordered by the Morton code of U, so that pixels close in the order have close
/// Gaussian points. Every k-th index is a stratified subset of the joint distribution.
std::vector<std::uint32_t> spatialOrder(const std::vector<Point>& gaussian, int dimensions) {
  constexpr int kBits = 10; // per coordinate; 2^30 codes
  std::vector<std::pair<std::uint32_t, std::uint32_t>> codes(gaussian.size());
  for (std::size_t i = 0; i < gaussian.size(); ++i) {
    const std::array<float, 3> g{gaussian[i].x, gaussian[i].y, gaussian[i].z};
    std::uint32_t code = 0;
    for (int axis = 0; axis < dimensions; ++axis) {
      const double u = gaussian::gaussianCdf(double(g[std::size_t(axis)]));
      const auto cell = std::min(std::uint32_t(u * (1 << kBits)), (1u << kBits) - 1);
      for (int bit = 0; bit < kBits; ++bit)
        code |= ((cell >> bit) & 1u) << (bit * dimensions + axis);
    }
    codes[i] = {code, std::uint32_t(i)};
  }
  std::sort(codes.begin(), codes.end());
  std::vector<std::uint32_t> order(codes.size());
  std::transform(codes.begin(), codes.end(), order.begin(), [](const auto& c) { return c.second; });
  return order;
}

/// The quantile function of the projected values, averaged exactly over each cell: D = 1. Many
/// pixels share a Gaussian value of 8 bits; the points order them.
InverseTable fitQuantiles(const Gaussianized& gaussian, std::span<const Point> points,
                          std::span<const float> decoded, int channels) {
  InverseTable table{1, kTableSide[0], channels, {}};
  const std::size_t count = gaussian.matched.size();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(gaussian.matched[a].x, points[a].x) <
           std::pair(gaussian.matched[b].x, points[b].x);
  });
  for (int cell = 0; cell < table.side; ++cell) {
    const double begin = double(cell) * double(count) / table.side;
    const double end = double(cell + 1) * double(count) / table.side;
    std::array<double, exemplar::kMaxChannels> sum{};
    for (auto k = std::size_t(begin); k < count && double(k) < end; ++k) {
      const double overlap = std::min(end, double(k) + 1.0) - std::max(begin, double(k));
      for (int c = 0; c < channels; ++c)
        sum[std::size_t(c)] +=
            overlap * double(decoded[order[k] * std::size_t(channels) + std::size_t(c)]);
    }
    for (int c = 0; c < channels; ++c)
      table.values.push_back(float(sum[std::size_t(c)] / (end - begin)));
  }
  return table;
}

/// Mean pixels per cell at and above which a cell's value is their mean.
constexpr std::size_t kLeastToAverage = 4;

/// Shares of a pixel in the cells of an axis from `first` on; their sum is 1.
struct CellShares {
  int first = 0;
  int count = 1;
  std::array<double, 2> shares{1.0, 0.0};
};

/// A pixel is spread over the 8-bit step around its Gaussian value, whatever its stored precision:
/// in the middle of an axis a cell is 1.7 such steps wide, and at least as wide elsewhere.
CellShares cellShares(double gaussian, int side) {
  static_assert(kTableSide[1] <= 64); // otherwise a step may span three cells
  constexpr double kHalfStep = 0.5 / 255.0;
  const double begin = gaussian::gaussianCdf(gaussian - kHalfStep) * side;
  const double end = gaussian::gaussianCdf(gaussian + kHalfStep) * side;
  CellShares result{std::clamp(int(begin), 0, side - 1)};
  const double border = result.first + 1.0;
  if (end <= border || result.first == side - 1)
    return result;
  const double share = (border - begin) / (end - begin);
  result.count = 2;
  result.shares = {share, 1.0 - share};
  return result;
}

/// The mean of each cell's pixels, in two dimensions; nothing if there are few pixels. With one
/// pixel per cell, adjacent cells in the tails of a distribution, whose values lie far apart, would
/// differ visibly: magnified slopes would show such cells as contour lines.
std::optional<InverseTable> fitMeans(const Gaussianized& gaussian, std::span<const float> decoded,
                                     int channels) {
  if (gaussian.matched.size() < kLeastToAverage * power(kTableSide[1], 2))
    return std::nullopt;
  InverseTable table{2, kTableSide[1], channels, {}};
  const auto count = std::size_t(channels);
  std::vector<double> weights(power(table.side, 2)), sums(weights.size() * count);
  for (std::size_t i = 0; i < gaussian.matched.size(); ++i) {
    const CellShares x = cellShares(double(gaussian.matched[i].x), table.side);
    const CellShares y = cellShares(double(gaussian.matched[i].y), table.side);
    for (int v = 0; v < y.count; ++v)
      for (int u = 0; u < x.count; ++u) {
        const auto cell = std::size_t((y.first + v) * table.side + x.first + u);
        const double share = x.shares[std::size_t(u)] * y.shares[std::size_t(v)];
        weights[cell] += share;
        for (std::size_t c = 0; c < count; ++c)
          sums[cell * count + c] += share * double(decoded[i * count + c]);
      }
  }
  if (std::find(weights.begin(), weights.end(), 0.0) != weights.end())
    return std::nullopt;
  for (std::size_t k = 0; k < sums.size(); ++k)
    table.values.push_back(float(sums[k] / weights[k / count]));
  return table;
}

/// One pixel's value per cell, by a second transport. Averaging two pixels per cell brings the
/// round trip 5 % closer but blurs the histogram by a third (docs/decisions/002-inverse-tables.md).
InverseTable fitByTransport(const Gaussianized& gaussian, std::span<const Point> points,
                            std::span<const float> decoded, int channels,
                            const TransportOptions& options) {
  InverseTable table{
      gaussian.dimensions, kTableSide[std::size_t(gaussian.dimensions - 1)], channels, {}};
  const std::vector<Point> middles = cellMiddles(table.dimensions, table.side);

  // As many pixels as cells, evenly over the joint distribution; repeated if there are fewer.
  const std::vector<std::uint32_t> order = spatialOrder(gaussian.matched, gaussian.dimensions);
  std::vector<std::uint32_t> chosen(middles.size());
  std::vector<Point> chosenPoints(middles.size());
  std::vector<Point> chosenGaussian(middles.size());
  for (std::size_t m = 0; m < middles.size(); ++m) {
    const auto place =
        std::size_t((double(m) + 0.5) * double(points.size()) / double(middles.size()));
    chosen[m] = order[std::min(place, points.size() - 1)];
    chosenPoints[m] = points[chosen[m]];
    chosenGaussian[m] = gaussian.matched[chosen[m]];
  }

  // Gaussian to Gaussian is nearly the identity: a start that the next line improves.
  const std::vector<std::uint32_t> cellOf = transport::improveAssignment(
      chosenPoints, middles, transport::assign(chosenGaussian, middles, transport::kFastTransport),
      options);

  table.values.resize(middles.size() * std::size_t(channels));
  for (std::size_t m = 0; m < middles.size(); ++m)
    std::copy_n(&decoded[chosen[m] * std::size_t(channels)], channels,
                &table.values[cellOf[m] * std::size_t(channels)]);
  return table;
}

} // namespace

std::vector<float> axisMiddles(int side) {
  std::vector<float> middles;
  for (int k = 0; k < side; ++k)
    middles.push_back(float(gaussian::gaussianQuantile((k + 0.5) / side)));
  return middles;
}

std::vector<Point> cellMiddles(int dimensions, int side) {
  const std::vector<float> onAxis = axisMiddles(side);
  std::vector<Point> middles(power(side, dimensions));
  for (std::size_t cell = 0; cell < middles.size(); ++cell) {
    std::array<float, 3> g{0.0f, 0.0f, 0.0f};
    std::size_t rest = cell;
    for (std::size_t axis = 0; axis < std::size_t(dimensions); ++axis, rest /= std::size_t(side))
      g[axis] = onAxis[rest % std::size_t(side)];
    middles[cell] = {g[0], g[1], g[2]};
  }
  return middles;
}

exemplar::Moments interpolatedMoments(const InverseTable& table) {
  const auto n = Eigen::Index(table.channels);
  const auto cells = double(table.cellCount());
  std::vector<std::vector<double>> planes(std::size_t(table.channels));
  for (std::size_t c = 0; c < planes.size(); ++c)
    for (std::size_t i = c; i < table.values.size(); i += planes.size())
      planes[c].push_back(double(table.values[i]));
  exemplar::Moments moments{exemplar::ChannelVector::Zero(n), exemplar::ChannelMatrix::Zero(n, n)};
  for (Eigen::Index c = 0; c < n; ++c)
    moments.mean[c] =
        std::accumulate(planes[std::size_t(c)].begin(), planes[std::size_t(c)].end(), 0.0) / cells;
  for (Eigen::Index c = 0; c < n; ++c) {
    std::vector<double> smoothed = planes[std::size_t(c)];
    std::size_t stride = 1;
    for (int axis = 0; axis < table.dimensions; ++axis, stride *= std::size_t(table.side))
      smoothed = applyMass(smoothed, table.side, stride);
    for (Eigen::Index d = 0; d < n; ++d)
      moments.covariance(c, d) = std::inner_product(smoothed.begin(), smoothed.end(),
                                                    planes[std::size_t(d)].begin(), 0.0) /
                                     cells -
                                 moments.mean[c] * moments.mean[d];
  }
  return moments;
}

InverseTable fitInverseTable(const Gaussianized& gaussian, std::span<const Point> points,
                             std::span<const float> decoded, int channels,
                             const TransportOptions& options, CellValue value) {
  std::optional<InverseTable> fitted;
  if (gaussian.dimensions == 1)
    fitted = fitQuantiles(gaussian, points, decoded, channels);
  else if (value == CellValue::mean && gaussian.dimensions == 2)
    fitted = fitMeans(gaussian, decoded, channels);
  InverseTable table =
      fitted ? *std::move(fitted) : fitByTransport(gaussian, points, decoded, channels, options);
  matchMoments(table, decoded);
  return table;
}

} // namespace lichen::gaussian
