// SPDX-License-Identifier: MIT
// Prefiltered slabs of the inverse table, so that a filtered Gaussian value decodes to the average.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <array>
#include <vector>

namespace lichen::tiling {

/// Slabs of a table: steps of 1/7 in kept amplitude (docs/decisions/002-inverse-table.md).
inline constexpr int kTableLevels = 8;

/// levels[k] = 1 - (1 - k / (kTableLevels - 1))^2, the lost variance of slab k: kTableLevels values
/// from 0 to 1, in units of the full variance.
[[nodiscard]] std::vector<double> tableLevels();

/// The covariance that fetches have lost when its mean over the channels is `level`: between
/// nothing, the mips' in `lost` and everything.
[[nodiscard]] exemplar::ChannelMatrix lossAt(double level,
                                             const std::vector<exemplar::ChannelMatrix>& lost);

/// Zero-mean Gaussian displacements, stratified, with the covariance `loss` / 36.
[[nodiscard]] std::vector<std::array<float, 3>>
lossDisplacements(const exemplar::ChannelMatrix& loss, std::size_t count);

/// Slab k of the result is E[T^-1(g + e)] with e ~ N(0, S / 36) and S the covariance that fetches
/// have lost when the mean loss is levels[k]: interpolated between the mips' in `lost`. Slab 0 is
/// the table itself, the last the constant mean. `lost` has at least one matrix, symmetric and with
/// eigenvalues in [0, 1], of as many rows as the table has dimensions. Throws std::bad_alloc.
[[nodiscard]] std::vector<InverseTable>
prefilteredSlabs(const InverseTable& table, const std::vector<exemplar::ChannelMatrix>& lost);

/// The same with the covariance that each slab's fetches have lost: kTableLevels of them.
[[nodiscard]] std::vector<InverseTable>
prefilteredSlabsFor(const InverseTable& table, const std::vector<exemplar::ChannelMatrix>& losses);

/// The slabs (at least one, all of one shape) as one KTX2-ready table: D = 1 2-D (256 x L), D = 2
/// 2-D (64 x 64 L), D = 3 3-D (32 x 32 x 32 L). Format by encoding and bits, 8 or 16: RGBA8 SRGB
/// for light, RGBA8 UNORM for other data in [0, 1], RGBA16F otherwise; one- and two-channel data as
/// R and RG. A fourth channel is 1.
[[nodiscard]] Table inverseTableTexels(const std::vector<InverseTable>& slabs,
                                       ValueEncoding encoding, int bits);

} // namespace lichen::tiling
