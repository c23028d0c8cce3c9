// SPDX-License-Identifier: MIT
// Prefilters slabs of the inverse table, so that a filtered Gaussian value decodes to the average.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <array>
#include <vector>

namespace lichen::tiling {

/// Number of slabs in a table, 1/7 apart in kept amplitude (docs/decisions/002-inverse-table.md).
inline constexpr int kTableLevels = 8;

/// levels[k] = 1 - (1 - k / (kTableLevels - 1))^2, the lost variance of slab k: kTableLevels values
/// from 0 to 1, in units of the full variance.
[[nodiscard]] std::vector<double> tableLevels();

/// The lost covariance whose mean over the channels is `level`, interpolated between 0, the mip
/// levels' losses in `lost` and the identity.
[[nodiscard]] exemplar::ChannelMatrix lossAt(double level,
                                             const std::vector<exemplar::ChannelMatrix>& lost);

/// Zero-mean Gaussian displacements, stratified, with the covariance `loss` / 36.
[[nodiscard]] std::vector<std::array<float, 3>>
lossDisplacements(const exemplar::ChannelMatrix& loss, std::size_t count);

/// Slab k of the result is E[T^-1(g + e)] with e ~ N(0, S / 36), where S is the lost covariance
/// whose mean is levels[k], interpolated between the mip levels' losses in `lost`. Slab 0 is the
/// table itself, the last one the constant mean. `lost` has at least one matrix; each is symmetric,
/// has eigenvalues in [0, 1] and as many rows as the table has dimensions. Throws std::bad_alloc.
[[nodiscard]] std::vector<InverseTable>
prefilteredSlabs(const InverseTable& table, const std::vector<exemplar::ChannelMatrix>& lost);

/// Packs the slabs (at least one, all of one shape) into one KTX2-ready table: 2-D (256 x L) for
/// D = 1, 2-D (64 x 64 L) for D = 2, 3-D (32 x 32 x 32 L) for D = 3. The encoding and bits, 8 or
/// 16, select the format: RGBA8 SRGB for light, RGBA8 UNORM for other data in [0, 1], otherwise
/// RGBA16F; data with one or two channels uses R or RG. A fourth channel is 1.
[[nodiscard]] Table inverseTableTexels(const std::vector<InverseTable>& slabs,
                                       ValueEncoding encoding, int bits);

} // namespace lichen::tiling
