// SPDX-License-Identifier: MIT
// Colours (N, 3) -> centres of clusters (count, 3). Source: [AV07], k-means++.
#include "color_clusters.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <utility>

namespace lichen::layers {
namespace {

/// [AV07] section 2.2: each start is a colour drawn in proportion to its squared distance from the
/// starts before it.
std::vector<Lab> starts(std::span<const Lab> colors, std::size_t count, std::mt19937& generator) {
  // The bits as they are: distributions differ between libraries.
  const auto random = [&] { return double(generator()) * 0x1p-32; };
  std::vector<Lab> centers{colors[std::size_t(random() * double(colors.size()))]};
  while (centers.size() < count) {
    std::vector<double> sums;
    double sum = 0.0;
    for (const Lab& color : colors)
      sums.push_back(sum += double(squaredDistance(color, centers[nearestOf(centers, color)])));
    if (sum == 0.0)
      break;
    const auto drawn = std::upper_bound(sums.begin(), sums.end(), random() * sum);
    centers.push_back(colors[std::size_t(std::min(drawn, sums.end() - 1) - sums.begin())]);
  }
  return centers;
}

/// Moves each centre to the mean of its colours; returns the sum of squared distances before.
double moveToMeans(std::span<const Lab> colors, std::vector<Lab>& centers) {
  std::vector<std::array<double, 4>> sums(centers.size()); // the last one counts
  double error = 0.0;
  for (const Lab& color : colors) {
    const std::size_t k = nearestOf(centers, color);
    error += double(squaredDistance(color, centers[k]));
    for (std::size_t c = 0; c < color.size(); ++c)
      sums[k][c] += double(color[c]);
    sums[k][3] += 1.0;
  }
  for (std::size_t k = 0; k < centers.size(); ++k)
    for (std::size_t c = 0; c < centers[k].size(); ++c)
      if (sums[k][3] > 0.0)
        centers[k][c] = float(sums[k][c] / sums[k][3]);
  return error;
}

} // namespace

float squaredDistance(const Lab& a, const Lab& b) {
  float sum = 0.0f;
  for (std::size_t c = 0; c < a.size(); ++c)
    sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

std::size_t nearestOf(std::span<const Lab> centers, const Lab& color) {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < centers.size(); ++k)
    if (squaredDistance(centers[k], color) < squaredDistance(centers[nearest], color))
      nearest = k;
  return nearest;
}

std::vector<Lab> clusterCenters(std::span<const Lab> colors, std::size_t count) {
  constexpr int kStarts = 8, kMostRounds = 60;
  constexpr double kConverged = 1e-5; // relative change of the error
  std::mt19937 generator(1);
  std::pair<double, std::vector<Lab>> best;
  for (int start = 0; start < kStarts; ++start) {
    std::vector<Lab> centers = starts(colors, count, generator);
    double error = moveToMeans(colors, centers);
    for (int round = 0; round < kMostRounds; ++round) {
      const double before = std::exchange(error, moveToMeans(colors, centers));
      if (before - error <= kConverged * before)
        break;
    }
    if (best.second.empty() || error < best.first)
      best = {error, std::move(centers)};
  }
  std::sort(best.second.begin(), best.second.end());
  return best.second;
}

} // namespace lichen::layers
