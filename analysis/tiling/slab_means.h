// SPDX-License-Identifier: MIT
// Makes slabs preserve the mean at every distance, although mip levels are not quite Gaussian.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <array>
#include <vector>

namespace lichen::tiling {

/// Means of a slab's channels and of their squares over blended trilinear fetches of the stored
/// `gaussian` image, at the level of detail where the share `level` of the variance is lost. `lost`
/// holds the losses of that image's mip levels.
struct FetchMoments {
  std::array<double, 4> mean{};
  std::array<double, 4> square{};
};
[[nodiscard]] FetchMoments fetchMoments(const InverseTable& slab, const Table& gaussian,
                                        double level,
                                        const std::vector<exemplar::ChannelMatrix>& lost);

/// Shifts each slab but the first and the last so that its lookups at blended trilinear fetches of
/// the stored `gaussian` image average to the last slab, the mean. Shifted values are clamped to
/// the range of slab 0, which limits the correction. `lost` holds the losses of that image's mip
/// levels. The mip levels of an exemplar with few large features are far from Gaussian, which
/// shifts the mean of their decoded values by up to 0.004 of full light.
void restoreSlabMeans(std::vector<InverseTable>& slabs, const Table& gaussian,
                      const std::vector<exemplar::ChannelMatrix>& lost);

} // namespace lichen::tiling
