// SPDX-License-Identifier: MIT
// A power plane in blocks of frequencies, by which models of it are judged.
#pragma once

#include "random_phase/power_tree.h"

#include <array>
#include <vector>

namespace lichen::multiple_kernels {

/// Frequencies around (u, v) with a common mean power.
struct FrequencyBlock {
  double u = 0.0, v = 0.0;
  double width = 1.0, height = 1.0;
  double count = 0.0; ///< frequencies of column 0 count half
  double power = 0.0; ///< mean
};
using FrequencyBlocks = std::vector<FrequencyBlock>;

/// Blocks whose sides are at most an eighth of their distance from the frequency 0, and smaller
/// where the power varies more than by chance.
[[nodiscard]] FrequencyBlocks blocksOf(const random_phase::PowerPlane& power);

/// Blocks of all directions, 24 an octave: `u` is the length of their frequencies.
[[nodiscard]] FrequencyBlocks radialBlocks(const FrequencyBlocks& blocks);

/// A floor: this share of the mean power is added to all powers.
inline constexpr double kLeastPower = 1e-3;
[[nodiscard]] double leastPower(const FrequencyBlocks& blocks, double share = kLeastPower);

/// How much a block counts: its number of frequencies, but less than 16, as a model is off by a
/// quarter where a mean of 16 powers is.
[[nodiscard]] double weightOf(const FrequencyBlock& block);

/// The signed root of twice the distance of one block, P / S - 1 - log(P / S) times its weight, and
/// its derivative by the modelled power S. Both powers have `least` added.
[[nodiscard]] std::array<double, 2> residualOf(const FrequencyBlock& block, double least,
                                               double modelled);

/// The sum of the squares of residualOf() when each block has the mean power of those as far from
/// the frequency 0. Nothing that is alike in all directions comes much nearer.
[[nodiscard]] double distanceOfRadialMeans(const FrequencyBlocks& blocks);

} // namespace lichen::multiple_kernels
