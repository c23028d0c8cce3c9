// SPDX-License-Identifier: MIT
// A table for each axis of a decorrelated basis of the decoded values: small, and no 3-D texture.
#pragma once

#include "gaussianize.h"
#include "inverse_table.h"
#include "mip_chain.h"

#include <vector>

namespace lichen::tiling {

/// Decoded values = offset + basis t, t one value an axis; an axis' table takes a Gaussian value
/// to t.
struct SeparableFit {
  exemplar::ChannelMatrix
      basis; ///< n x D, orthonormal columns: principal axes of the decoded values
  exemplar::ChannelVector offset;   ///< n: their mean
  std::vector<Gaussianized> axes;   ///< D images of one dimension
  std::vector<InverseTable> tables; ///< D tables of one dimension and one channel
  [[nodiscard]] int dimensions() const { return int(axes.size()); }
};

/// Gaussianizes each principal axis of the map's decoded values by sorting. Mean and covariance of
/// the decoded values are exact, the joint histogram is not: axes are taken for independent.
/// Tells `options.progress`.
[[nodiscard]] SeparableFit fitSeparable(const MapExemplar& map, bool periodic,
                                        gaussian::Precision precision,
                                        const transport::TransportOptions& options);

/// The axes' images as one of D dimensions.
[[nodiscard]] Gaussianized combinedImage(const SeparableFit& fit);

/// Slabs of one dimension and D channels: slab k of axis a is prefiltered for what the axis has
/// lost where the mean over the axes is tableLevels()[k]. `lost` is of the combined image, stored.
[[nodiscard]] std::vector<InverseTable>
separableSlabs(const SeparableFit& fit, int bits, const std::vector<exemplar::ChannelMatrix>& lost);

} // namespace lichen::tiling
