// SPDX-License-Identifier: MIT
// What the images of the peers contain, computed from an exemplar. The benchmark measures only
// costs, so the simplest contents of the right kind serve: each channel is made Gaussian by itself,
// in the order of its values.
#pragma once

#include <lichen/image.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lichen::bench {

/// RGBA8 texels of all mip levels, level 0 first. A 3-D image has one level.
struct PeerTexels {
  std::uint32_t width = 1, height = 1, depth = 1, mipLevels = 1;
  std::vector<std::byte> texels;
};

using PeerColor = std::array<float, 4>;

struct PeerContents {
  PeerTexels exemplar;
  PeerTexels gaussianImage;     ///< of the exemplar's RGB: mean 1/2, deviation 1/6
  PeerTexels colorTable;        ///< 32 x 32 x 32: distribution function of a Gaussian value -> RGB
  PeerTexels decorrelatedImage; ///< of the exemplar along its principal axes
  /// 128 x mip levels of decorrelatedImage: Gaussian value, [0, 1] -> value along each axis. Row l
  /// is averaged over the variance that mip level l lost.
  PeerTexels axisTable;
  PeerColor colorOrigin{};              ///< RGB = origin + sum of axes[k] times the k-th value
  std::array<PeerColor, 3> colorAxes{}; ///< alpha unused
  std::array<double, 3> mean{};         ///< of the exemplar's code values
};

/// `exemplar`: RGB, square, the side a power of two.
[[nodiscard]] PeerContents peerContents(const SrgbImage& exemplar);

} // namespace lichen::bench
