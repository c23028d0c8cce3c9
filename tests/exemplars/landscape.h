// SPDX-License-Identifier: MIT
// A landscape of a million triangles that reaches from the camera to the horizon, for noise without
// texture coordinates at all distances.
#pragma once

#include <cstddef>
#include <vector>

namespace lichen::exemplars {

/// A GLB of the ground within three kilometres of the camera 'view', with normals and three
/// materials: 'ground'; 'rock' on steep slopes; and 'rock edge', a blended layer around the rock
/// whose alpha is the share of rock. 1,000,000 triangles plus the layer's, 29 MB. The result is
/// deterministic. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> landscapeGlb();

} // namespace lichen::exemplars
