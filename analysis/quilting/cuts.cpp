// SPDX-License-Identifier: MIT
#include <lichen/lattice.h>
#include <lichen/quilting_cuts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lichen {
namespace {

/// A level of an image.
struct Level {
  int width = 0, height = 0;
  std::size_t channels = 0;
  std::vector<float> values;

  [[nodiscard]] const float* at(int x, int y) const {
    return &values[(std::size_t(y % height) * std::size_t(width) + std::size_t(x % width)) *
                   channels];
  }
};

/// The first level that has at most so many columns.
Level levelOf(const Table& table, int mostColumns) {
  std::uint32_t level = 0;
  while (level + 1 < table.mipLevels && int(table.width >> level) > mostColumns)
    ++level;
  return {std::max(1, int(table.width >> level)), std::max(1, int(table.height >> level)),
          std::size_t(channelCount(table.format)), decodeLevel(table, level)};
}

/// The texels to whose right or lower side there is another cell.
std::vector<std::array<int, 2>> outlinesOf(const Level& cells, double reach) {
  const auto wayAt = [&](int x, int y) {
    const float* const texel = cells.at(x, y);
    return std::array<double, 2>{reach * (2.0 * double(texel[0]) - 1.0),
                                 reach * (2.0 * double(texel[1]) - 1.0)};
  };
  double squares = 0.0;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x)
      squares += std::pow(wayAt(x, y)[0], 2.0) + std::pow(wayAt(x, y)[1], 2.0);
  // Centres of neighbouring cells are about twice as far apart as texels are from their centres.
  const double far = std::sqrt(squares / (double(cells.width) * cells.height));
  std::vector<std::array<int, 2>> outlines;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x) {
      const std::array<double, 2> way = wayAt(x, y), right = wayAt(x + 1, y),
                                  below = wayAt(x, y + 1);
      if (std::hypot(right[0] - way[0], right[1] - way[1]) > far ||
          std::hypot(below[0] - way[0], below[1] - way[1]) > far)
        outlines.push_back({x, y});
    }
  return outlines;
}

/// Ways from one tile to another, in texels of the level.
std::vector<std::array<int, 2>> waysBetweenTiles(const QuiltingNoise& noise, const Level& level) {
  constexpr std::uint32_t kDraws = 24; // if tiles are taken from anywhere
  std::vector<std::array<int, 2>> ways;
  for (const std::array<double, 2>& offset : noise.offsets)
    if (offset[0] != 0.0 || offset[1] != 0.0)
      ways.push_back(
          {int(std::lround(offset[0] * level.width)), int(std::lround(offset[1] * level.height))});
  if (noise.offsets.empty())
    for (std::uint32_t k = 0; k < kDraws; ++k)
      ways.push_back({int(pcg(2 * k) % std::uint32_t(level.width)),
                      int(pcg(2 * k + 1) % std::uint32_t(level.height))});
  return ways;
}

std::optional<double> mismatch(const Bundle& bundle, const Noise& noise, const NoiseMap& map) {
  const auto& own = map.as<QuiltingMap>();
  const auto& shared = noise.as<QuiltingNoise>();
  const Table& cellTable = bundle.tables[own.cells];
  const Level image = levelOf(bundle.tables[own.image], int(cellTable.width));
  const Level cells = levelOf(cellTable, image.width);
  const std::size_t channels = map.channels.size();
  const auto differenceOf = [&](int x, int y, int otherX, int otherY) {
    double sum = 0.0;
    for (std::size_t c = 0; c < channels; ++c)
      sum += std::pow(double(image.at(x, y)[c]) - double(image.at(otherX, otherY)[c]), 2.0);
    return sum;
  };
  // Of unrelated texels: twice the variance.
  std::vector<double> means(channels), squares(channels);
  const double count = double(image.width) * image.height;
  for (std::size_t i = 0; i < image.values.size(); i += image.channels)
    for (std::size_t c = 0; c < channels; ++c) {
      means[c] += double(image.values[i + c]) / count;
      squares[c] += std::pow(double(image.values[i + c]), 2.0) / count;
    }
  double unrelated = 0.0;
  for (std::size_t c = 0; c < channels; ++c)
    unrelated += 2.0 * (squares[c] - means[c] * means[c]);
  const std::vector<std::array<int, 2>> outlines = outlinesOf(cells, shared.reach);
  const std::vector<std::array<int, 2>> ways = waysBetweenTiles(shared, image);
  constexpr double kNoVariance = 1e-9;
  if (outlines.empty() || ways.empty() || unrelated < kNoVariance)
    return std::nullopt;
  double sum = 0.0;
  for (const auto& [x, y] : outlines)
    for (const auto& [wayX, wayY] : ways)
      sum += differenceOf(x, y, x + wayX, y + wayY);
  return sum / (double(outlines.size()) * double(ways.size()) * unrelated);
}

} // namespace

Result<std::optional<double>> cutMismatch(const Bundle& bundle, const Noise& noise,
                                          const NoiseMap& map) {
  const auto exhausted = [&] { return noise.name + ": not enough memory to compare tiles"; };
  return withinMemory(
      exhausted, [&]() -> Result<std::optional<double>> { return mismatch(bundle, noise, map); });
}

} // namespace lichen
