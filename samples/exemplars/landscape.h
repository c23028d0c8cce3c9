// SPDX-License-Identifier: MIT
// A landscape from the feet to the horizon, of a million triangles: for noise that needs no texture
// coordinates, near and far.
#pragma once

#include <cstddef>
#include <vector>

namespace lichen::exemplars {

/// Ground within three kilometres of a camera, 'view', with normals, as the file of a scene with
/// two materials: 'ground', and 'rock' where it is steep. 1,000,000 triangles, 24 MB; the same
/// bytes each time. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> landscapeGlb();

} // namespace lichen::exemplars
