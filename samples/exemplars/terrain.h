// SPDX-License-Identifier: MIT
// A hilly ground, and where rock shows on it: for a mix of textons with a mask.
#pragma once

#include <lichen/image.h>

#include <cstddef>
#include <vector>

namespace lichen::exemplars {

/// Ground of 12 x 12 metres with normals and texture coordinates that cover it once, as the file of
/// a scene with one material, 'terrain', and a camera 'view'. The same bytes each time. Throws
/// std::bad_alloc.
[[nodiscard]] std::vector<std::byte> terrainGlb();

/// The mask in those texture coordinates, grey, `sidePixels` a side, rounded to 8 bits: 1 where the
/// ground is steep, 0 where it is flat.
[[nodiscard]] SrgbImage terrainMask(int sidePixels);

} // namespace lichen::exemplars
