// SPDX-License-Identifier: MIT
// Hilly ground and a mask of its rock, for a mix of textons with a mask.
#pragma once

#include <lichen/image.h>

#include <cstddef>
#include <vector>

namespace lichen::exemplars {

/// A GLB of 12 x 12 metres of ground with normals and texture coordinates that cover it once, one
/// material, 'terrain', and a camera 'view'. The result is deterministic. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> terrainGlb();

/// The mask for these texture coordinates: grey, `sidePixels` pixels per side, rounded to 8 bits; 1
/// on steep ground, 0 on flat ground.
[[nodiscard]] SrgbImage terrainMask(int sidePixels);

} // namespace lichen::exemplars
