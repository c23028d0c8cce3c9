// SPDX-License-Identifier: MIT
// The Gaussian image as the shader fetches it: a table with mip levels and their lost variance.
#pragma once

#include "exemplar/color_space.h"
#include "gaussianize.h"

#include <lichen/bundle.h>
#include <lichen/table.h>

#include <vector>

namespace lichen::gaussian {

/// Stores the image as an RG8 (D = 1) or RGBA8 table, or for 16 bits as RG16F or RGBA16F, with all
/// mip levels down to 1 x 1. Each texel is the area average of the next finer level, so odd sides
/// lose no row. The last channel is fetchLoss() of the level. Throws std::bad_alloc.
[[nodiscard]] Table gaussianTable(const Gaussianized& gaussianized, int bits);

/// Returns Cov(level 0) - Cov(level) for each mip level of the stored table, in units of the
/// variance of a channel: 0 for level 0, the identity if all variance is lost. The first
/// `dimensions` channels count.
[[nodiscard]] std::vector<exemplar::ChannelMatrix> lostVariance(const Table& gaussian,
                                                                int dimensions);

/// The mean over the channels of a loss matrix.
[[nodiscard]] double scalarLoss(const exemplar::ChannelMatrix& loss);

/// The share of the variance of level 0 that a trilinear fetch loses, one value for each mip level,
/// in [0, 1] and never decreasing: interpolated linearly between the levels it is, in the least
/// squares, what fetches at all positions between texels lose on average. Level 0 has exactly the
/// loss of a bilinear fetch. `dimensions` of the table's channels count. Throws std::bad_alloc.
[[nodiscard]] std::vector<double> fetchLoss(const Table& gaussian, int dimensions);

} // namespace lichen::gaussian
