// SPDX-License-Identifier: MIT
// One table per axis of a decorrelated basis of the decoded values: small, and no 3-D texture.
#pragma once

#include "gaussianize.h"
#include "inverse_table.h"
#include "mip_chain.h"

#include <vector>

namespace lichen::tiling {

/// Decoded values = offset + basis t, with one value of t per axis; the table of an axis maps a
/// Gaussian value to its t.
struct SeparableFit {
  exemplar::ChannelMatrix
      basis; ///< n x D, orthonormal columns: principal axes of the decoded values
  exemplar::ChannelVector offset;   ///< n: mean of the decoded values
  std::vector<Gaussianized> axes;   ///< D images of one dimension
  std::vector<InverseTable> tables; ///< D tables of one dimension and one channel
  [[nodiscard]] int dimensions() const { return int(axes.size()); }
};

/// Gaussianizes each principal axis of the map's decoded values by sorting. Mean and covariance of
/// the decoded values are exact. The joint histogram is not, because axes are treated as
/// independent.
[[nodiscard]] SeparableFit fitSeparable(const MapExemplar& map, bool periodic,
                                        gaussian::Precision precision, ProgressPart progress);

/// Combines the axes' images into one image of D dimensions.
[[nodiscard]] Gaussianized combinedImage(const SeparableFit& fit);

/// Makes slabs of one dimension and D channels. Slab k of axis a is prefiltered for the axis's own
/// loss when the mean loss over the axes is tableLevels()[k]. `lost` is the loss of the stored
/// combined image.
[[nodiscard]] std::vector<InverseTable>
separableSlabs(const SeparableFit& fit, int bits, const std::vector<exemplar::ChannelMatrix>& lost);

} // namespace lichen::tiling
