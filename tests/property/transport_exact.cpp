// SPDX-License-Identifier: MIT
#include "transport_exact.h"

#include <limits>

namespace lichen::test {
namespace {

double squaredDistance(const Point& a, const Point& b) {
  const double dx = double(a.x) - double(b.x);
  const double dy = double(a.y) - double(b.y);
  const double dz = double(a.z) - double(b.z);
  return dx * dx + dy * dy + dz * dz;
}

/// Rows and columns are numbered from 1; column 0 stands for "not yet assigned".
class Hungarian {
public:
  Hungarian(std::span<const Point> source, std::span<const Point> target)
      : source_(source), target_(target), rowPotential_(source.size() + 1, 0.0),
        columnPotential_(source.size() + 1, 0.0), rowOf_(source.size() + 1, 0),
        previous_(source.size() + 1, 0) {}

  std::vector<std::uint32_t> solve() {
    for (std::size_t row = 1; row <= source_.size(); ++row)
      insert(row);
    std::vector<std::uint32_t> assignment(source_.size());
    for (std::size_t column = 1; column <= source_.size(); ++column)
      assignment[rowOf_[column] - 1] = std::uint32_t(column - 1);
    return assignment;
  }

private:
  void insert(std::size_t row) {
    const std::size_t columns = source_.size() + 1;
    std::vector<double> least(columns, std::numeric_limits<double>::infinity());
    std::vector<bool> inTree(columns, false);
    rowOf_[0] = row;
    std::size_t column = 0;
    while (rowOf_[column] != 0) {
      inTree[column] = true;
      const std::size_t reached = rowOf_[column];
      double step = std::numeric_limits<double>::infinity();
      std::size_t next = 0;
      for (std::size_t c = 1; c < columns; ++c) {
        if (inTree[c])
          continue;
        const double reduced = squaredDistance(source_[reached - 1], target_[c - 1]) -
                               rowPotential_[reached] - columnPotential_[c];
        if (reduced < least[c]) {
          least[c] = reduced;
          previous_[c] = column;
        }
        if (least[c] < step) {
          step = least[c];
          next = c;
        }
      }
      for (std::size_t c = 0; c < columns; ++c) {
        if (inTree[c]) {
          rowPotential_[rowOf_[c]] += step;
          columnPotential_[c] -= step;
        } else {
          least[c] -= step;
        }
      }
      column = next;
    }
    for (; column != 0; column = previous_[column])
      rowOf_[column] = rowOf_[previous_[column]];
  }

  std::span<const Point> source_;
  std::span<const Point> target_;
  std::vector<double> rowPotential_;
  std::vector<double> columnPotential_;
  std::vector<std::size_t> rowOf_;
  std::vector<std::size_t> previous_;
};

} // namespace

std::vector<std::uint32_t> exactAssignment(std::span<const Point> source,
                                           std::span<const Point> target) {
  return Hungarian(source, target).solve();
}

double transportCost(std::span<const Point> source, std::span<const Point> target,
                     std::span<const std::uint32_t> assignment) {
  double sum = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i)
    sum += squaredDistance(source[i], target[assignment[i]]);
  return source.empty() ? 0.0 : sum / double(source.size());
}

double centredCost(std::span<const Point> source, std::span<const Point> target,
                   std::span<const std::uint32_t> assignment) {
  double sx = 0.0, sy = 0.0, sz = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    sx += double(source[i].x) - double(target[i].x);
    sy += double(source[i].y) - double(target[i].y);
    sz += double(source[i].z) - double(target[i].z);
  }
  const double count = double(source.size());
  return transportCost(source, target, assignment) -
         (sx * sx + sy * sy + sz * sz) / (count * count);
}

} // namespace lichen::test
