// SPDX-License-Identifier: MIT
// Makes a table's levels keep the mean at every distance, although mip levels of the Gaussian image
// are not quite Gaussian.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"
#include "sampling/texels.h"

#include <lichen/table.h>

#include <array>
#include <vector>

namespace lichen::gaussian {

/// Means of the looked-up values of a level and of their squares.
struct FetchMoments {
  std::array<double, 4> mean{};
  std::array<double, 4> square{};
};
/// Those over blended trilinear fetches of the stored `gaussian` image at the level of detail where
/// fetches lose what table level `level` is prefiltered for; `losses` are its fetchLosses(). Where
/// fetches at all levels of detail lose more, the fetched values are scaled about their mean.
[[nodiscard]] FetchMoments fetchMoments(const InverseTable& table, int level,
                                        const RepeatingImage& gaussian,
                                        const std::vector<float>& losses);

/// Shifts each level but the first so that its lookups at blended fetches of the stored `gaussian`
/// image, squared where `holdsRoots` is set, average to the lookups of the first. Shifted values
/// are clamped to the range of the first level, which limits the correction. The mip levels of an
/// exemplar with few large features are far from Gaussian, which shifts the mean of their decoded
/// values by up to 0.004 of full light. Views more distant than the last level decode to one colour
/// at its middle: of roots, its own mean is half their variance too bright, and those views half of
/// it too dark.
void restoreLevelMeans(std::vector<InverseTable>& levels, bool holdsRoots, const Table& gaussian,
                       const std::vector<float>& losses);

/// Appends a channel to each level of a slope map's table: the variance of a slope, (Var sx + Var
/// sy) / 2 of T^-1(g + e), with e ~ N(0, S / 36) as for the levels' means; 0 in level 0. `levels`
/// are the prefiltered levels of `table` with restored means; `gaussian` is the stored image,
/// `lost` and `losses` are the losses of its mip levels and of fetches. The true e is not quite
/// Gaussian, so one number scales each level's channel: over blended fetches of the stored mip
/// levels, its mean and the variance of the level's slopes then add up to the whole. Throws
/// std::bad_alloc.
void appendSlopeVariance(std::vector<InverseTable>& levels, const InverseTable& table,
                         const Table& gaussian, const std::vector<exemplar::ChannelMatrix>& lost,
                         const std::vector<float>& losses);

} // namespace lichen::gaussian
