// SPDX-License-Identifier: MIT
// Gaussian values -> the inverse table's value, interpolated linearly between cells.
#pragma once

#include "gaussian_distribution.h"
#include "inverse_table.h"

#include <algorithm>
#include <array>
#include <vector>

namespace lichen::tiling {

/// Cell coordinate of a Gaussian value, side * U - 1/2, tabulated: evaluated some 10^7 times.
class CellCoordinate {
public:
  explicit CellCoordinate(int side) {
    for (int k = 0; k <= kSteps + 1; ++k)
      values_[std::size_t(k)] = float(side * gaussianCdf(kLow + k * (kHigh - kLow) / kSteps) - 0.5);
  }
  [[nodiscard]] float operator()(float gaussian) const {
    const float place =
        std::clamp((gaussian - float(kLow)) * float(kSteps / (kHigh - kLow)), 0.0f, float(kSteps));
    const auto index = std::size_t(place);
    return values_[index] + (place - float(index)) * (values_[index + 1] - values_[index]);
  }

private:
  static constexpr int kSteps = 4096;
  static constexpr double kLow = -0.5; // six deviations each way
  static constexpr double kHigh = 1.5;
  std::array<float, kSteps + 2> values_{};
};

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

  using Value = std::array<float, 4>;

  [[nodiscard]] Value operator()(const std::array<float, 3>& gaussian) const {
    std::size_t base = 0;
    std::array<std::size_t, kDimensions> step{};
    std::array<float, kDimensions> fraction{};
    std::size_t stride = 1;
    for (std::size_t axis = 0; axis < kDimensions; ++axis, stride *= side_) {
      const float place = std::clamp(coordinate_(gaussian[axis]), 0.0f, float(side_ - 1));
      const auto cell = std::size_t(place);
      base += cell * stride;
      step[axis] = cell + 1 < side_ ? stride : 0;
      fraction[axis] = place - float(cell);
    }
    return interpolated<kDimensions>(&cells_[base], step, fraction);
  }

private:
  template <std::size_t kAxes>
  static Value interpolated(const Value* cell, const std::array<std::size_t, kDimensions>& step,
                            const std::array<float, kDimensions>& fraction) {
    if constexpr (kAxes == 0) {
      return *cell;
    } else {
      const Value low = interpolated<kAxes - 1>(cell, step, fraction);
      const Value high = interpolated<kAxes - 1>(cell + step[kAxes - 1], step, fraction);
      Value result;
      for (std::size_t c = 0; c < 4; ++c)
        result[c] = low[c] + fraction[kAxes - 1] * (high[c] - low[c]);
      return result;
    }
  }

  std::size_t side_;
  CellCoordinate coordinate_;
  std::vector<Value> cells_;
};

} // namespace lichen::tiling
