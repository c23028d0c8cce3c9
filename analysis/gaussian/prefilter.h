// SPDX-License-Identifier: MIT
// The mip levels of the inverse table: each averages over the variance that filtering has lost, so
// that a filtered Gaussian value decodes to the average.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <array>
#include <vector>

namespace lichen::gaussian {

/// Mip levels of a table, and the amplitude that a Gaussian value keeps at one of them: 1, 0.8, ...
/// 0.2 (docs/decisions/002-inverse-tables.md).
inline constexpr int kTableLevels = 5;
[[nodiscard]] constexpr double retainedAmplitude(int level) {
  return 1.0 - double(level) / kTableLevels;
}
/// The lost variance for which a level is prefiltered, as a share of the full variance.
[[nodiscard]] constexpr double levelLoss(int level) {
  return 1.0 - retainedAmplitude(level) * retainedAmplitude(level);
}

/// The lost covariance whose mean over the channels is `loss`, interpolated between 0, the mip
/// levels' losses in `lost` and the identity.
[[nodiscard]] exemplar::ChannelMatrix lossAt(double loss,
                                             const std::vector<exemplar::ChannelMatrix>& lost);

/// Zero-mean Gaussian displacements, stratified, with the covariance `loss` / 36.
[[nodiscard]] std::vector<std::array<float, 3>>
lossDisplacements(const exemplar::ChannelMatrix& loss, std::size_t count);

/// Returns a table of as many cells that holds E[T^-1(g + e)], e ~ N(0, loss / 36), at the cells'
/// centres: `loss` is symmetric, has eigenvalues in [0, 1] and as many rows as the table has
/// dimensions. Throws std::bad_alloc.
[[nodiscard]] InverseTable averaged(const InverseTable& table, const exemplar::ChannelMatrix& loss);

/// The mip levels of a table. Level 0 is `table` itself. Level k has half as many cells on each
/// axis as the one before, and is the least-squares fit, for Gaussian values that keep
/// retainedAmplitude(k), of the average over the lost variance; `lost` has the losses of the
/// Gaussian image's mip levels, at least one. Where `holdsRoots` is set, cells hold square roots:
/// their squares are averaged, and the fit is of the root of the average. Throws std::bad_alloc.
[[nodiscard]] std::vector<InverseTable>
prefilteredLevels(const InverseTable& table, const std::vector<exemplar::ChannelMatrix>& lost,
                  bool holdsRoots);

/// Packs the levels into one 3-D table with mip levels. The encoding and `bits`, 8 or 16, select
/// the format: UNORM for roots of light and data in [0, 1], otherwise half floats. Tables of one
/// and two channels use R and RG; a fourth channel is 1.
[[nodiscard]] Table inverseTableTexels(const std::vector<InverseTable>& levels,
                                       ValueEncoding encoding, int bits);

/// The table of `side` cells on each axis whose lookups differ least, in the mean square, from
/// lookups of `table`, at Gaussian values of standard deviation `amplitude` / 6 about 1/2,
/// amplitude in (0, 1]. Throws std::bad_alloc.
[[nodiscard]] InverseTable coarser(const InverseTable& table, int side, double amplitude);

} // namespace lichen::gaussian
