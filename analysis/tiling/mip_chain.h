// SPDX-License-Identifier: MIT
// The Gaussian image as the shader fetches it: a table with mip levels and their lost variance.
#pragma once

#include "exemplar/color_space.h"
#include "gaussianize.h"

#include <lichen/bundle.h>

#include <vector>

namespace lichen::tiling {

/// Stores the image as an R8, RG8, RGBA8 (bits 8) or R16F, RG16F, RGBA16F (bits 16) table with all
/// mip levels down to 1 x 1. Each texel is the area average of the next finer level, so odd sides
/// lose no row. D = 3 is stored with alpha 1.
[[nodiscard]] Table gaussianTable(const Gaussianized& gaussianized, int bits);

/// Returns Cov(level 0) - Cov(level) for each mip level of the stored table, in units of the
/// variance of a channel: 0 for level 0, the identity if all variance is lost.
[[nodiscard]] std::vector<exemplar::ChannelMatrix> lostVariance(const Table& gaussian);

/// The mean over the channels of a loss matrix: the scalar that mipLoss and levels store.
[[nodiscard]] double scalarLoss(const exemplar::ChannelMatrix& loss);

} // namespace lichen::tiling
