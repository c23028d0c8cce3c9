// SPDX-License-Identifier: MIT
// Exemplar (width * height values per channel) -> the strength of the seams between its borders.
#include "borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace lichen::exemplar {
namespace {

constexpr int kFewestForDetection = 8;

// Measured on exemplars that tile, lit exemplars and crops: docs/decisions/005-exemplar.md.
constexpr double kStandoutLimit = 1.75;
constexpr double kHighest = 0.98;
constexpr double kRatioLimit = 1.22;
constexpr double kHigh = 0.9;
constexpr std::array kBoxAspects{4, 16}; // length of a box along the line over its width across
constexpr int kScaleStep = 4;            // between the widths of boxes
constexpr int kFewestAcross = 32; // boxes across a side; wider ones leave too few to compare with
constexpr int kFewestAlong = 2;   // boxes along a line
constexpr int kBlocks = 8;        // of a line
constexpr int kSurroundings = 8;  // a line is compared with lines within side / 8 on either side

/// Per block of a line: the sum of a difference over the block's boxes and all channels.
using Blocks = std::array<double, kBlocks>;

/// The lines of a map: columns if `alongX`, else rows.
struct Lines {
  const MapExemplar& map;
  int count;  ///< of lines
  int length; ///< of a line
  std::size_t lineStride;
  std::size_t stride;

  Lines(const MapExemplar& of, bool alongX)
      : map(of), count(alongX ? of.width : of.height), length(alongX ? of.height : of.width),
        lineStride(of.channels.size() * (alongX ? 1u : std::size_t(of.width))),
        stride(of.channels.size() * (alongX ? std::size_t(of.width) : 1u)) {}

  /// The sum of a channel over the pixels from `begin` to `end` of a line.
  [[nodiscard]] double sum(int line, int begin, int end, std::size_t channel) const {
    const float* values = &map.values[std::size_t(line) * lineStride + channel];
    double total = 0.0;
    for (int k = begin; k < end; ++k)
      total += double(values[std::size_t(k) * stride]);
    return total;
  }
};

/// Returns, for every k, how much the boxes of `across` pixels on both sides of the border between
/// lines k and k + 1 (wrapping) differ: the absolute difference of their means.
std::vector<Blocks> boxDifferences(const Lines& lines, int across, int boxes) {
  std::vector<Blocks> differences(std::size_t(lines.count), Blocks{});
  std::vector<double> sums(std::size_t(lines.count));
  const auto at = [&](int line) { return sums[std::size_t((line + lines.count) % lines.count)]; };
  for (std::size_t c = 0; c < lines.map.channels.size(); ++c)
    for (int box = 0; box < boxes; ++box) {
      const auto begin = int(std::int64_t(box) * lines.length / boxes);
      const auto end = int(std::int64_t(box + 1) * lines.length / boxes);
      for (int line = 0; line < lines.count; ++line)
        sums[std::size_t(line)] = lines.sum(line, begin, end, c);
      double step = 0.0; // the box behind line k less the box before it, here for k = -1
      for (int k = 0; k < across; ++k)
        step += at(k) - at(-1 - k);
      for (int line = 0; line < lines.count; ++line) {
        step += at(line + across) - 2.0 * at(line) + at(line - across);
        differences[std::size_t(line)][std::size_t(box * kBlocks / boxes)] +=
            std::abs(step) / (double(across) * (end - begin));
      }
    }
  return differences;
}

/// Joins the blocks of each line; the rest of the array is zero.
void joinBlocks(std::vector<Blocks>& differences) {
  for (Blocks& line : differences)
    line = {std::accumulate(line.begin(), line.end(), 0.0)};
}

/// Returns, for every line, the greatest ratio of a block to the mean of that block over the lines
/// around. `rounding` is added to the mean.
std::vector<double> greatestRatios(const std::vector<Blocks>& differences, double rounding) {
  const int count = int(differences.size());
  const int reach =
      std::min(std::max(count / kSurroundings, kFewestForDetection / 2), (count - 1) / 2);
  const auto at = [&](int line) -> const Blocks& {
    return differences[std::size_t((line + count) % count)];
  };
  std::vector<double> ratios(differences.size(), 0.0);
  for (std::size_t b = 0; b < kBlocks; ++b) {
    double sum = 0.0;
    for (int k = -1 - reach; k < reach; ++k)
      sum += at(k)[b];
    for (int line = 0; line < count; ++line) {
      sum += at(line + reach)[b] - at(line - reach - 1)[b];
      const double mean = std::max(sum, 0.0) / (2 * reach + 1) + rounding;
      ratios[std::size_t(line)] = std::max(ratios[std::size_t(line)], at(line)[b] / mean);
    }
  }
  return ratios;
}

/// The seam's value, and quantiles of the lines inside.
struct Standing {
  double seam = 0.0, median = 0.0, high = 0.0, highest = 0.0;
};

/// `ratios` of all lines; the last is the seam, and lines whose boxes of `across` pixels reach
/// across it do not count.
Standing standingOf(std::vector<double> ratios, int across) {
  const double seam = ratios.back();
  ratios.erase(ratios.end() - across, ratios.end());
  ratios.erase(ratios.begin(), ratios.begin() + across - 1);
  const auto quantile = [&](double share) {
    const auto place = ratios.begin() + std::ptrdiff_t(share * double(ratios.size()));
    std::nth_element(ratios.begin(), place, ratios.end());
    return *place;
  };
  return {seam, quantile(0.5), quantile(kHigh), quantile(kHighest)};
}

/// The share of the limit that `excess` over the unit is. Infinite if only the seam has any.
double shareOfLimit(double excess, double unit, double limit) {
  constexpr double kRounding = 1e-9; // of the sums that slide along the lines
  if (excess <= kRounding)
    return 0.0;
  return unit > kRounding ? excess / (limit * unit) : std::numeric_limits<double>::infinity();
}

double standout(const Standing& s) {
  return shareOfLimit(s.seam - s.median, s.highest - s.median, kStandoutLimit);
}

double strengthOf(const Lines& lines) {
  if (lines.count < kFewestForDetection)
    return 0.0;
  double strength = 0.0;
  for (int across = 1; across == 1 || lines.count >= kFewestAcross * across; across *= kScaleStep)
    for (const int aspect : kBoxAspects) {
      const bool isFinest = across == 1 && aspect == kBoxAspects.front();
      const int boxes = std::max(1, lines.length / (aspect * across));
      if (boxes < kFewestAlong && !isFinest)
        continue;
      std::vector<Blocks> differences = boxDifferences(lines, across, boxes);
      const double rounding = 0.5 * lines.map.quantum * boxes;
      const Standing blocks = standingOf(greatestRatios(differences, rounding / kBlocks), across);
      joinBlocks(differences);
      const Standing whole = standingOf(greatestRatios(differences, rounding), across);
      strength = std::max({strength, standout(blocks), standout(whole)});
      if (isFinest)
        strength = std::max(strength, shareOfLimit(whole.seam, whole.high, kRatioLimit));
    }
  return strength;
}

} // namespace

SeamStrength seamStrength(const MapExemplar& map) {
  return {strengthOf(Lines(map, true)), strengthOf(Lines(map, false))};
}

bool isPeriodic(const MapExemplar& map) {
  const SeamStrength strength = seamStrength(map);
  return std::max(strength.betweenColumns, strength.betweenRows) <= 1.0;
}

} // namespace lichen::exemplar

bool lichen::bordersFit(std::span<const MapExemplar> maps, Periodic periodic) {
  return periodic == Periodic::yes ||
         (periodic == Periodic::detect && std::ranges::all_of(maps, exemplar::isPeriodic));
}
