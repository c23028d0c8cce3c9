// SPDX-License-Identifier: MIT
// Power (rows, columns) -> boxes, by trees of axis-aligned cuts: a regression tree for exemplars,
// and halves of equal power for spectra that are 0 nearly everywhere.
//
// In place of the strata and sub-strata of [LRP14] section 4.2:
// docs/decisions/009-local-random-phase.md.
#include "power_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace lichen::random_phase {
namespace {

/// Weighted sums of 1, p and p^2 over boxes, with weights p^-exponent.
class WeightedSums {
public:
  WeightedSums(const PowerPlane& power, double exponent, double least)
      : stride_(std::size_t(power.columns) + 1),
        sums_(stride_ * (std::size_t(power.rows) + 1), Sums{}) {
    for (std::size_t y = 0; y < std::size_t(power.rows); ++y)
      for (std::size_t x = 0; x < std::size_t(power.columns); ++x) {
        const bool isZero = x == 0 && y == std::size_t(power.rows / 2);
        const double p = power.values[y * std::size_t(power.columns) + x];
        const double weight = (isZero ? 0.0 : x == 0 ? 0.5 : 1.0) * std::pow(p + least, -exponent);
        const std::array<double, 3> own{weight, weight * p, weight * p * p};
        for (std::size_t k = 0; k < 3; ++k)
          sums_[(y + 1) * stride_ + x + 1][k] = own[k] + sums_[y * stride_ + x + 1][k] +
                                                sums_[(y + 1) * stride_ + x][k] -
                                                sums_[y * stride_ + x][k];
      }
  }

  /// The weighted squared error of the weighted mean over columns [left, right), rows [top, bottom)
  /// from the plane's first.
  [[nodiscard]] double error(int left, int right, int top, int bottom) const {
    const auto at = [&](int row, int column) -> const Sums& {
      return sums_[std::size_t(row) * stride_ + std::size_t(column)];
    };
    const Sums &a = at(top, left), &b = at(top, right), &c = at(bottom, left),
               &d = at(bottom, right);
    Sums sum;
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] = d[k] - b[k] - c[k] + a[k];
    return sum[0] > 0.0 ? std::max(0.0, sum[2] - sum[1] * sum[1] / sum[0]) : 0.0;
  }

private:
  using Sums = std::array<double, 3>;
  std::size_t stride_;
  std::vector<Sums> sums_;
};

/// Exponents of the weights of the absolute and of the relative error, and the share of the former.
/// With 50 cosines, on eleven exemplars: docs/decisions/009-local-random-phase.md.
constexpr double kAbsolute = 0.6, kRelative = 1.6, kAbsoluteShare = 0.6;

/// Powers below this share of the largest one count as if they were it.
constexpr double kLeastPower = 1e-6;

class Tree {
public:
  explicit Tree(const PowerPlane& power)
      : half_(power.rows / 2),
        least_(kLeastPower * *std::max_element(power.values.begin(), power.values.end()) + 1e-300),
        absolute_(power, kAbsolute, least_), relative_(power, kRelative, least_) {
    const FrequencyBox whole{0, power.columns, -half_, half_ + 1};
    const auto share = [&](const WeightedSums& sums, double part) {
      const double error = sums.error(0, power.columns, 0, power.rows);
      return error > 0.0 ? part / error : 0.0;
    };
    absoluteScale_ = share(absolute_, kAbsoluteShare);
    relativeScale_ = share(relative_, 1.0 - kAbsoluteShare);
    leaves_.push_back(withBestCut(whole));
  }

  /// Splits the leaf that gains most. Returns false if none gains.
  bool split() {
    const auto best =
        std::max_element(leaves_.begin(), leaves_.end(),
                         [](const Leaf& a, const Leaf& b) { return a.gain < b.gain; });
    if (!(best->gain > 0.0))
      return false;
    FrequencyBox first = best->box, second = best->box;
    if (best->cutsColumns)
      first.right = second.left = best->cut;
    else
      first.bottom = second.top = best->cut;
    *best = withBestCut(first);
    leaves_.push_back(withBestCut(second));
    return true;
  }

  [[nodiscard]] std::vector<FrequencyBox> boxes() const {
    std::vector<FrequencyBox> result;
    for (const Leaf& leaf : leaves_)
      result.push_back(leaf.box);
    return result;
  }

private:
  struct Leaf {
    FrequencyBox box;
    double gain = 0.0;
    bool cutsColumns = false;
    int cut = 0;
  };

  [[nodiscard]] double error(int left, int right, int top, int bottom) const {
    return absoluteScale_ * absolute_.error(left, right, top + half_, bottom + half_) +
           relativeScale_ * relative_.error(left, right, top + half_, bottom + half_);
  }

  [[nodiscard]] Leaf withBestCut(const FrequencyBox& box) const {
    Leaf leaf{box};
    const double whole = error(box.left, box.right, box.top, box.bottom);
    const auto offer = [&](bool cutsColumns, int cut, double rest) {
      if (whole - rest > leaf.gain)
        leaf = {box, whole - rest, cutsColumns, cut};
    };
    for (int cut = box.left + 1; cut < box.right; ++cut)
      offer(true, cut,
            error(box.left, cut, box.top, box.bottom) + error(cut, box.right, box.top, box.bottom));
    for (int cut = box.top + 1; cut < box.bottom; ++cut)
      offer(false, cut,
            error(box.left, box.right, box.top, cut) + error(box.left, box.right, cut, box.bottom));
    return leaf;
  }

  int half_;
  double least_;
  WeightedSums absolute_, relative_;
  double absoluteScale_ = 0.0, relativeScale_ = 0.0;
  std::vector<Leaf> leaves_;
};

/// A box of a plane with its power, shrunk to where that is.
struct PowerBox {
  FrequencyBox box;
  double power = 0.0;
};

/// The power of each column or of each row of a box.
std::vector<double> profileOf(const PowerPlane& power, const FrequencyBox& box, bool ofColumns) {
  std::vector<double> profile(std::size_t(ofColumns ? box.right - box.left : box.bottom - box.top));
  for (int v = box.top; v < box.bottom; ++v)
    for (int u = box.left; u < box.right; ++u)
      profile[std::size_t(ofColumns ? u - box.left : v - box.top)] +=
          (u == 0 ? 0.5 : 1.0) * (u == 0 && v == 0 ? 0.0 : power.at(u, v));
  return profile;
}

PowerBox shrunk(const PowerPlane& power, FrequencyBox box) {
  PowerBox result{box};
  for (const bool ofColumns : {true, false}) {
    const std::vector<double> profile = profileOf(power, result.box, ofColumns);
    result.power = std::accumulate(profile.begin(), profile.end(), 0.0);
    const auto holds = [&](double own) { return own > kLeastPower * result.power; };
    const auto first = std::find_if(profile.begin(), profile.end(), holds);
    const auto last = std::find_if(profile.rbegin(), profile.rend(), holds);
    if (first == profile.end())
      return result;
    int& low = ofColumns ? result.box.left : result.box.top;
    int& high = ofColumns ? result.box.right : result.box.bottom;
    high = low + int(profile.rend() - last);
    low += int(first - profile.begin());
  }
  return result;
}

} // namespace

std::vector<FrequencyBox> boxesAroundPower(const PowerPlane& power, std::size_t count) {
  const int half = power.rows / 2;
  std::vector<PowerBox> boxes{shrunk(power, {0, power.columns, -half, half + 1})};
  const auto canSplit = [](const PowerBox& each) {
    return each.box.right - each.box.left + each.box.bottom - each.box.top > 2;
  };
  while (boxes.size() < count) {
    const auto strongest =
        std::max_element(boxes.begin(), boxes.end(), [&](const PowerBox& a, const PowerBox& b) {
          return std::pair(canSplit(a), a.power) < std::pair(canSplit(b), b.power);
        });
    if (!canSplit(*strongest) || !(strongest->power > 0.0))
      break;
    FrequencyBox first = strongest->box, second = strongest->box;
    const bool cutsColumns = first.right - first.left > first.bottom - first.top;
    const std::vector<double> profile = profileOf(power, first, cutsColumns);
    double before = 0.0;
    std::size_t cut = 0;
    while (cut + 2 < profile.size() && before + 0.5 * profile[cut] < 0.5 * strongest->power)
      before += profile[cut++];
    cut = std::max<std::size_t>(cut, 1);
    if (cutsColumns)
      first.right = second.left = first.left + int(cut);
    else
      first.bottom = second.top = first.top + int(cut);
    *strongest = shrunk(power, first);
    boxes.push_back(shrunk(power, second));
  }
  std::vector<FrequencyBox> result;
  for (const PowerBox& each : boxes)
    result.push_back(each.box);
  return result;
}

PowerPlane smoothed(const PowerPlane& power) {
  PowerPlane result = power;
  const int half = power.rows / 2;
  tbb::parallel_for(-half, half + 1, [&](int v) {
    for (int u = 0; u < power.columns; ++u) {
      double sum = 0.0, weights = 0.0;
      for (int dv = -1; dv <= 1; ++dv)
        for (int du = -1; du <= 1; ++du) {
          int x = u + du, y = v + dv;
          if (x < 0) { // the mirror
            x = -x;
            y = -y;
          }
          if (x >= power.columns || std::abs(y) > half || (x == 0 && y == 0))
            continue;
          const double weight = double((2 - std::abs(du)) * (2 - std::abs(dv)));
          sum += weight * power.at(x, y);
          weights += weight;
        }
      result.values[std::size_t(v + half) * std::size_t(power.columns) + std::size_t(u)] =
          weights > 0.0 ? sum / weights : 0.0;
    }
  });
  return result;
}

std::vector<FrequencyBox> boxesOfEqualPower(const PowerPlane& power, std::size_t count) {
  Tree tree(power);
  std::size_t boxes = 1;
  while (boxes < count && tree.split())
    ++boxes;
  return tree.boxes();
}

} // namespace lichen::random_phase
