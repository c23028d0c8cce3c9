// SPDX-License-Identifier: MIT
// A landscape from the feet to the horizon, of a million triangles: for noise that needs no texture
// coordinates, near and far.
#pragma once

#include <cstddef>
#include <vector>

namespace lichen::exemplars {

/// Ground within three kilometres of a camera, 'view', with normals, as the file of a scene with
/// three materials: 'ground'; 'rock' where it is steep; and 'rock edge', a layer on the ground
/// around it, as opaque as there is rock. 1,000,000 triangles and those of the layer, 29 MB; the
/// same bytes each time. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> landscapeGlb();

} // namespace lichen::exemplars
