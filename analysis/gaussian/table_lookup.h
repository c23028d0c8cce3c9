// SPDX-License-Identifier: MIT
// Looks up Gaussian values in the inverse table, with linear interpolation between cells.
#pragma once

#include "gaussian_distribution.h"
#include "inverse_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lichen::gaussian {

/// Cell coordinate of a Gaussian value, side * U - 1/2. Tabulated, as it is evaluated about 10^7
/// times.
class CellCoordinate {
public:
  explicit CellCoordinate(int side) {
    for (int k = 0; k <= kSteps + 1; ++k)
      values_[std::size_t(k)] =
          float(side * gaussian::gaussianCdf(kLow + k * (kHigh - kLow) / kSteps) - 0.5);
  }
  [[nodiscard]] float operator()(float gaussian) const {
    const float place =
        std::clamp((gaussian - float(kLow)) * float(kSteps / (kHigh - kLow)), 0.0f, float(kSteps));
    const auto index = std::size_t(place);
    return values_[index] + (place - float(index)) * (values_[index + 1] - values_[index]);
  }

private:
  static constexpr int kSteps = 4096;
  static constexpr double kLow = -0.5; // six standard deviations either side of the mean
  static constexpr double kHigh = 1.5;
  std::array<float, kSteps + 2> values_{};
};

/// A cell's channels, padded to four. The vector type loads and adds all four at once at any
/// optimization level, so sanitizers check once instead of four times.
using TableValue = float __attribute__((vector_size(4 * sizeof(float))));

/// The table with its cells padded to four channels, for lookups at Gaussian values.
template <std::size_t kDimensions>
class TableLookup {
public:
  explicit TableLookup(const InverseTable& table)
      : side_(std::size_t(table.side)), coordinate_(table.side), cells_(table.cellCount()) {
    for (std::size_t i = 0; i < cells_.size(); ++i)
      for (std::size_t c = 0; c < std::size_t(table.channels); ++c)
        cells_[i][c] = table.values[i * std::size_t(table.channels) + c];
  }

  /// Position of a value along one axis: between cell `cell`, an index into the table's cells, and
  /// the cell `step` after it.
  struct Place {
    std::size_t cell;
    std::size_t step;
    float fraction;
  };

  [[nodiscard]] Place along(std::size_t axis, float gaussian) const {
    std::size_t stride = 1;
    for (std::size_t k = 0; k < axis; ++k)
      stride *= side_;
    const float place = std::clamp(coordinate_(gaussian), 0.0f, float(side_ - 1));
    const auto cell = std::size_t(place);
    return {cell * stride, cell + 1 < side_ ? stride : 0, place - float(cell)};
  }

  /// Looks up at one position along each axis.
  template <class... Places>
  [[nodiscard]] TableValue at(const Places&... places) const {
    static_assert(sizeof...(places) == kDimensions);
    return interpolated(&cells_[(places.cell + ...)], places...);
  }

  [[nodiscard]] TableValue operator()(const std::array<float, 3>& gaussian) const {
    if constexpr (kDimensions == 1)
      return at(along(0, gaussian[0]));
    else if constexpr (kDimensions == 2)
      return at(along(0, gaussian[0]), along(1, gaussian[1]));
    else
      return at(along(0, gaussian[0]), along(1, gaussian[1]), along(2, gaussian[2]));
  }

private:
  static TableValue interpolated(const TableValue* cell) { return *cell; }

  template <class... Rest>
  static TableValue interpolated(const TableValue* cell, const Place& place, const Rest&... rest) {
    const TableValue low = interpolated(cell, rest...);
    const TableValue high = interpolated(cell + place.step, rest...);
    return low + place.fraction * (high - low);
  }

  std::size_t side_;
  CellCoordinate coordinate_;
  std::vector<TableValue> cells_;
};

/// [HN18] eq. 8 at a point uniform in the triangle, from two words of a hash. The squares of the
/// weights sum to 1.
[[nodiscard]] inline std::array<float, 3> randomBlendWeights(std::uint32_t first,
                                                             std::uint32_t second) {
  const auto random = [](std::uint32_t hash) { return float(hash >> 8u) * 0x1.0p-24f; };
  float a = random(first);
  float b = random(second);
  if (a + b > 1.0f) {
    a = 1.0f - a;
    b = 1.0f - b;
  }
  const float c = 1.0f - a - b;
  const float norm = std::sqrt(a * a + b * b + c * c);
  return {a / norm, b / norm, c / norm};
}

/// Position `k` of `count` that are spread evenly over the unit square: a lattice of the golden
/// ratio.
[[nodiscard]] inline std::array<float, 2> spreadPosition(std::uint32_t k, std::uint32_t count) {
  constexpr double kGoldenRatio = 0.61803398874989485;
  const double turns = kGoldenRatio * k;
  return {(float(k) + 0.5f) / float(count), float(turns - std::floor(turns))};
}

} // namespace lichen::gaussian
