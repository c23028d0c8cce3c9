// SPDX-License-Identifier: MIT
// Keeps the mean colour at every distance: what prefiltering assumes to be Gaussian is not quite.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <array>
#include <vector>

namespace lichen::tiling {

/// Means of a slab's channels and of their squares over blended trilinear fetches of the stored
/// `gaussian` image, at the place between mips where `level` of the variance is lost. `lost` is of
/// that image.
struct FetchMoments {
  std::array<double, 4> mean{};
  std::array<double, 4> square{};
};
[[nodiscard]] FetchMoments fetchMoments(const InverseTable& slab, const Table& gaussian,
                                        double level,
                                        const std::vector<exemplar::ChannelMatrix>& lost);

/// Shifts each slab but the first and the last so that its lookups at blended trilinear fetches of
/// the stored `gaussian` image average to the last slab, the mean, as far as the values that are
/// shifted stay in the range of slab 0, to which they are clamped. `lost` is of that image. The
/// mips of an exemplar with few large features are far from Gaussian, which displaces the mean of
/// their decoded values by up to 0.004 of full light.
void restoreSlabMeans(std::vector<InverseTable>& slabs, const Table& gaussian,
                      const std::vector<exemplar::ChannelMatrix>& lost);

} // namespace lichen::tiling
