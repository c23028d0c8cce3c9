// SPDX-License-Identifier: MIT
// Bundle with a quilting noise -> the texels on outlines of its cells -> how much two tiles differ
// there.
#include "placement/near_periods.h"
#include "sampling/texels.h"

#include <lichen/lattice.h>
#include <lichen/quilting.h>

#include <array>
#include <cmath>
#include <vector>

namespace lichen {
namespace {

using Value = RepeatingImage::Value;

/// width x height values, which repeat.
struct Grid {
  int width = 0, height = 0;
  std::vector<Value> values;

  [[nodiscard]] const Value& at(int x, int y) const {
    return values[std::size_t(y % height) * std::size_t(width) + std::size_t(x % width)];
  }
};

/// The image at the middle of each texel of another one, averaged over as much as that covers.
Grid sampled(const Table& image, const Table& other) {
  const RepeatingImage source(image);
  const double texels = double(image.width) * image.height;
  const auto level = float(0.5 * std::log2(texels / (double(other.width) * other.height)));
  Grid grid{int(other.width), int(other.height), {}};
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x)
      grid.values.push_back(source.at((float(x) + 0.5f) / float(grid.width),
                                      (float(y) + 0.5f) / float(grid.height), level));
  return grid;
}

/// The texels to whose right or lower side there is another cell.
std::vector<std::array<int, 2>> outlinesOf(const Grid& cells) {
  // To the centre of the cell, in units of its reach.
  const auto toCentre = [&](int x, int y) {
    const Value& texel = cells.at(x, y);
    return std::array{2.0 * double(texel[0]) - 1.0, 2.0 * double(texel[1]) - 1.0};
  };
  double squares = 0.0;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x)
      squares += std::pow(toCentre(x, y)[0], 2.0) + std::pow(toCentre(x, y)[1], 2.0);
  // Centres of neighbouring cells are about twice as far apart as texels are from their centres.
  const double far = std::sqrt(squares / double(cells.values.size()));
  std::vector<std::array<int, 2>> outlines;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x) {
      const std::array<double, 2> own = toCentre(x, y), right = toCentre(x + 1, y),
                                  below = toCentre(x, y + 1);
      if (std::hypot(right[0] - own[0], right[1] - own[1]) > far ||
          std::hypot(below[0] - own[0], below[1] - own[1]) > far)
        outlines.push_back({x, y});
    }
  return outlines;
}

/// From one tile to another: its list of offsets, or a sample of all. [texels of the grid]
std::vector<std::array<int, 2>> offsetsOf(const QuiltingNoise& noise, const Grid& grid) {
  constexpr std::uint32_t kDraws = 24;
  std::vector<std::array<int, 2>> result;
  for (const auto& [x, y] : noise.offsets)
    if (x != 0.0 || y != 0.0)
      result.push_back({placement::pixelsOf(x, grid.width), placement::pixelsOf(y, grid.height)});
  if (noise.offsets.empty())
    for (std::uint32_t k = 0; k < kDraws; ++k)
      result.push_back({int(pcg(2 * k) % std::uint32_t(grid.width)),
                        int(pcg(2 * k + 1) % std::uint32_t(grid.height))});
  return result;
}

std::optional<double> mismatch(const Bundle& bundle, const Noise& noise, const NoiseMap& map) {
  const auto& own = map.as<QuiltingMap>();
  const Table& cells = bundle.tables[own.cells];
  const Grid image = sampled(bundle.tables[own.image], cells);
  const std::size_t channels = map.channels.size();
  // The mean squared difference of unrelated texels is twice the variance.
  double unrelated = 0.0;
  for (std::size_t c = 0; c < channels; ++c) {
    double sum = 0.0, squares = 0.0;
    for (const Value& value : image.values) {
      sum += double(value[c]);
      squares += double(value[c]) * double(value[c]);
    }
    const double count = double(image.values.size());
    unrelated += 2.0 * (squares / count - sum * sum / (count * count));
  }
  const std::vector<std::array<int, 2>> outlines =
      outlinesOf(Grid{int(cells.width), int(cells.height), texelsOf(cells, 0)});
  const std::vector<std::array<int, 2>> offsets = offsetsOf(noise.as<QuiltingNoise>(), image);
  constexpr double kNoVariance = 1e-9;
  if (outlines.empty() || offsets.empty() || unrelated < kNoVariance)
    return std::nullopt;
  double sum = 0.0;
  for (const auto& [x, y] : outlines)
    for (const auto& [offsetX, offsetY] : offsets) {
      const Value &here = image.at(x, y), &there = image.at(x + offsetX, y + offsetY);
      for (std::size_t c = 0; c < channels; ++c)
        sum += std::pow(double(here[c]) - double(there[c]), 2.0);
    }
  return sum / (double(outlines.size()) * double(offsets.size()) * unrelated);
}

} // namespace

Result<std::optional<double>> cutMismatch(const Bundle& bundle, const Noise& noise,
                                          const NoiseMap& map) {
  const auto exhausted = [&] { return noise.name + ": not enough memory to compare tiles"; };
  return withinMemory(
      exhausted, [&]() -> Result<std::optional<double>> { return mismatch(bundle, noise, map); });
}

} // namespace lichen
