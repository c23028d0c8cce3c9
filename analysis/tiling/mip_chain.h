// SPDX-License-Identifier: MIT
// The Gaussian image as the shader fetches it: a table with mips, and what those fetches lose.
#pragma once

#include "exemplar/color_space.h"
#include "gaussianize.h"

#include <lichen/bundle.h>

#include <vector>

namespace lichen::tiling {

/// The image as an R8, RG8, RGBA8 (bits 8) or R16F, RG16F, RGBA16F (bits 16) table with all mips
/// down to 1 x 1. Each texel of a level is the area average of the level above, so odd sides
/// lose no row; D = 3 is stored with alpha 1.
[[nodiscard]] Table gaussianTable(const Gaussianized& gaussianized, int bits);

/// For each mip level of the stored table, Cov(level 0) - Cov(level), in units of the variance of a
/// channel: 0 for level 0, the identity where everything is lost.
[[nodiscard]] std::vector<exemplar::ChannelMatrix> lostVariance(const Table& gaussian);

/// The mean over the channels of a loss matrix: the scalar that mipLoss and levels state.
[[nodiscard]] double scalarLoss(const exemplar::ChannelMatrix& loss);

} // namespace lichen::tiling
