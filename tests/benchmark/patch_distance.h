// SPDX-License-Identifier: MIT
// How far the neighbourhoods of a result's pixels are from neighbourhoods in its exemplar.
#pragma once

#include <lichen/image.h>

namespace lichen::bench {

/// Sliced Wasserstein-2 distance between the 9 x 9 patches of the luminance, at most 96 x 96 of
/// them, one from a random place in each cell of a grid over the image: the root mean square over
/// 256 directions, in units of the code value of a pixel. Places and directions are the same at
/// each call. Equal sets give 0. Sides must be at least 9. Source: [RPDB12].
[[nodiscard]] double patchDistance(const SrgbImage& exemplar, const SrgbImage& result);

} // namespace lichen::bench
