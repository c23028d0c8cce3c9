// SPDX-License-Identifier: MIT
// The Gaussian image as the shader fetches it: a table with mip levels and their lost variance.
#pragma once

#include "exemplar/color_space.h"
#include "gaussianize.h"

#include <lichen/bundle.h>

#include <vector>

namespace lichen::gaussianization {

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

} // namespace lichen::gaussianization
