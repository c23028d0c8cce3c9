// SPDX-License-Identifier: MIT
// Power plane -> blocks of frequencies -> residuals of a model.
//
// The Itakura-Saito distance n (P / S - 1 - log(P / S)) is, up to a constant, minus the logarithm
// of the likelihood of the powers P of a Gaussian field of spectrum S [W53].
#include "frequency_blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen::multiple_kernels {

double weightOf(const FrequencyBlock& block) {
  constexpr double kMost = 16.0;
  return block.count / (1.0 + block.count / kMost);
}

double leastPower(const FrequencyBlocks& blocks, double share) {
  double sum = 0.0, count = 0.0;
  for (const FrequencyBlock& block : blocks) {
    sum += block.count * block.power;
    count += block.count;
  }
  return std::max(share * sum / std::max(count, 1.0), 1e-300);
}

namespace {

/// Splits a plane.
class Splitter {
public:
  explicit Splitter(const random_phase::PowerPlane& power) : power_(power) {
    double sum = 0.0, count = 0.0;
    for (int v = -half(); v <= half(); ++v)
      for (int u = 0; u < power.columns; ++u) {
        sum += weightAt(u, v) * power.at(u, v);
        count += weightAt(u, v);
      }
    least_ = std::max(kLeastPower * sum / std::max(count, 1.0), 1e-300);
  }

  /// Squares of kMostSide, cut in four until they are small enough, and then in two where halves
  /// differ.
  FrequencyBlocks blocks() {
    const int first = -(half() + kMostSide) / kMostSide * kMostSide;
    for (int top = first; top <= half(); top += kMostSide)
      for (int left = 0; left < power_.columns; left += kMostSide)
        addSquare(left, top, kMostSide);
    return std::move(blocks_);
  }

private:
  static constexpr int kSidesToZero = 8, kMostSide = 16;

  [[nodiscard]] int half() const { return power_.rows / 2; }
  static double weightAt(int u, int v) { return u == 0 && v == 0 ? 0.0 : u == 0 ? 0.5 : 1.0; }

  void addSquare(int left, int top, int side) {
    const random_phase::FrequencyBox box{left, std::min(left + side, power_.columns),
                                    std::max(top, -half()), std::min(top + side, half() + 1)};
    if (box.left >= box.right || box.top >= box.bottom)
      return;
    const int nearV = box.top > 0 ? box.top : std::max(1 - box.bottom, 0);
    if (side == 1 ||
        side * side * kSidesToZero * kSidesToZero <= box.left * box.left + nearV * nearV)
      return addParts(box);
    for (const int y : {top, top + side / 2})
      for (const int x : {left, left + side / 2})
        addSquare(x, y, side / 2);
  }

  [[nodiscard]] FrequencyBlock blockOf(const random_phase::FrequencyBox& box) const {
    FrequencyBlock block;
    for (int v = box.top; v < box.bottom; ++v)
      for (int u = box.left; u < box.right; ++u) {
        block.count += weightAt(u, v);
        block.power += weightAt(u, v) * power_.at(u, v);
      }
    if (block.count > 0.0)
      block.power /= block.count;
    block.u = 0.5 * (box.left + box.right - 1);
    block.v = 0.5 * (box.top + box.bottom - 1);
    block.width = box.right - box.left;
    block.height = box.bottom - box.top;
    return block;
  }

  /// What two powers gain over one, as the logarithm of the likelihood ratio.
  [[nodiscard]] double gainOf(const FrequencyBlock& whole, const FrequencyBlock& a,
                              const FrequencyBlock& b) const {
    const auto part = [&](const FrequencyBlock& block) {
      return block.count * std::log(block.power + least_);
    };
    return part(whole) - part(a) - part(b);
  }

  void addParts(const random_phase::FrequencyBox& box) {
    constexpr double kLeastGain = 8.0; // of many frequencies by chance once in 15,000 times
    const FrequencyBlock whole = blockOf(box);
    double best = kLeastGain;
    std::array<random_phase::FrequencyBox, 2> halves{};
    const auto consider = [&](const random_phase::FrequencyBox& a, const random_phase::FrequencyBox& b) {
      if (const double gain = gainOf(whole, blockOf(a), blockOf(b)); gain > best) {
        best = gain;
        halves = {a, b};
      }
    };
    if (const int middle = (box.left + box.right) / 2; middle > box.left)
      consider({box.left, middle, box.top, box.bottom}, {middle, box.right, box.top, box.bottom});
    if (const int middle = box.top + (box.bottom - box.top) / 2; middle > box.top)
      consider({box.left, box.right, box.top, middle}, {box.left, box.right, middle, box.bottom});
    if (best > kLeastGain)
      for (const random_phase::FrequencyBox& part : halves)
        addParts(part);
    else if (whole.count > 0.0)
      blocks_.push_back(whole);
  }

  const random_phase::PowerPlane& power_;
  double least_ = 0.0;
  FrequencyBlocks blocks_;
};

} // namespace

FrequencyBlocks blocksOf(const random_phase::PowerPlane& power) { return Splitter(power).blocks(); }

namespace {

/// A block's length, and the number of the ring it lies in, 24 an octave.
std::pair<double, std::size_t> ringOf(const FrequencyBlock& block) {
  constexpr double kPerOctave = 24.0;
  const double length = std::max(1.0, std::hypot(block.u, block.v));
  return {length, std::size_t(std::floor(kPerOctave * std::log2(length)))};
}

} // namespace

FrequencyBlocks radialBlocks(const FrequencyBlocks& blocks) {
  FrequencyBlocks rings;
  for (const FrequencyBlock& block : blocks) {
    const auto [length, ring] = ringOf(block);
    if (rings.size() <= ring)
      rings.resize(ring + 1);
    FrequencyBlock& own = rings[ring];
    own.u += block.count * length;
    own.power += block.count * block.power;
    own.count += block.count;
  }
  FrequencyBlocks kept;
  for (FrequencyBlock& ring : rings)
    if (ring.count > 0.0) {
      ring.u /= ring.count;
      ring.power /= ring.count;
      kept.push_back(ring);
    }
  return kept;
}

double distanceOfRadialMeans(const FrequencyBlocks& blocks) {
  std::vector<std::array<double, 2>> rings; // weights, and powers times weights
  for (const FrequencyBlock& block : blocks) {
    const std::size_t ring = ringOf(block).second;
    if (rings.size() <= ring)
      rings.resize(ring + 1);
    rings[ring][0] += weightOf(block);
    rings[ring][1] += weightOf(block) * block.power;
  }
  const double least = leastPower(blocks);
  double distance = 0.0;
  for (const FrequencyBlock& block : blocks) {
    const auto [weight, power] = rings[ringOf(block).second];
    distance += std::pow(residualOf(block, least, power / weight)[0], 2.0);
  }
  return distance;
}

std::array<double, 2> residualOf(const FrequencyBlock& block, double least, double modelled) {
  const double ratio = (block.power + least) / (modelled + least);
  const double distance = std::max(0.0, ratio - 1.0 - std::log(ratio));
  const double weight = weightOf(block);
  const double root = std::copysign(std::sqrt(2.0 * weight * distance), ratio - 1.0);
  constexpr double kNear = 1e-6; // where the quotient is 0 / 0
  const double slope =
      std::abs(ratio - 1.0) < kNear ? -std::sqrt(weight) : weight * (1.0 - ratio) / root;
  return {root, slope / (modelled + least)};
}

} // namespace lichen::multiple_kernels
