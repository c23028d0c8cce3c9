// SPDX-License-Identifier: MIT
// How well two square pictures, or the cells of one, agree when one is moved.
#pragma once

#include <lichen/image.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <structured.h>
#include <utility>
#include <vector>

namespace lichen::test {

/// Calls visit(i, j) for the indices of all pixels i that have a partner j at the rounded offset.
/// Only those count whose middle is within `reach` pixels of the middle, along both axes.
template <class Visit>
void forEachMoved(int side, const exemplars::Point& offset, float reach, const Visit& visit) {
  const int dx = int(std::lround(offset.x)), dy = int(std::lround(offset.y));
  const auto isNear = [&](int position, int step) {
    return std::abs(float(2 * position + step + 1 - side)) <= 2.0f * reach;
  };
  for (int y = std::max(0, -dy); y < side - std::max(0, dy); ++y)
    for (int x = std::max(0, -dx); x < side - std::max(0, dx); ++x)
      if (isNear(x, dx) && isNear(y, dy))
        visit(std::size_t(y) * std::size_t(side) + std::size_t(x),
              std::size_t(y + dy) * std::size_t(side) + std::size_t(x + dx));
}

/// A correlation from sums.
class Correlation {
public:
  void add(double a, double b) {
    ++count_;
    a_ += a;
    b_ += b;
    aa_ += a * a;
    bb_ += b * b;
    ab_ += a * b;
  }
  /// 0 if either does not vary.
  [[nodiscard]] double value() const {
    const double square = (aa_ - a_ * a_ / count_) * (bb_ - b_ * b_ / count_);
    return square > 0.0 ? (ab_ - a_ * b_ / count_) / std::sqrt(square) : 0.0;
  }

private:
  double count_ = 0.0, a_ = 0.0, b_ = 0.0, aa_ = 0.0, bb_ = 0.0, ab_ = 0.0;
};

inline constexpr float kWholePicture = std::numeric_limits<float>::infinity();

/// The correlation of the green of two pictures, the second moved.
inline double correlationOf(const SrgbImage& first, const SrgbImage& second,
                            const exemplars::Point& offset = {}, float reach = kWholePicture) {
  Correlation sums;
  forEachMoved(first.width, offset, reach, [&](std::size_t i, std::size_t j) {
    sums.add(double(first.values[3 * i + 1]), double(second.values[3 * j + 1]));
  });
  return sums.value();
}

struct CellAgreement {
  double cells = 0.0;  ///< share of the pixels of cells that stay with most of their cell
  double joints = 0.0; ///< correlation of the joints
};

/// How well the cells of a picture agree with themselves, moved.
inline CellAgreement cellAgreement(const std::vector<int>& cells, int side,
                                   const exemplars::Point& offset, float reach = kWholePicture) {
  Correlation joints;
  std::map<std::pair<int, int>, int> pairs;
  double count = 0.0;
  forEachMoved(side, offset, reach, [&](std::size_t i, std::size_t j) {
    joints.add(cells[i] < 0 ? 1.0 : 0.0, cells[j] < 0 ? 1.0 : 0.0);
    if (cells[i] >= 0 && cells[j] >= 0) {
      ++pairs[{cells[i], cells[j]}];
      count += 1.0;
    }
  });
  // The cell where most pixels of a cell are, and the one from which most of a cell's are.
  std::map<int, int> to, from;
  for (const auto& [pair, number] : pairs) {
    to[pair.first] = std::max(to[pair.first], number);
    from[pair.second] = std::max(from[pair.second], number);
  }
  const auto shareOf = [&](const std::map<int, int>& most) {
    double sum = 0.0;
    for (const auto& [cell, number] : most)
      sum += number;
    return sum / count;
  };
  return {std::min(shareOf(to), shareOf(from)), joints.value()};
}

} // namespace lichen::test
