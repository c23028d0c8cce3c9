// SPDX-License-Identifier: MIT
// Smooth 3-D noise for the example meshes.
#pragma once

#include <array>
#include <cstdint>

namespace lichen::exemplars {

/// Value noise: random values in [-1, 1] at integer positions, smooth in between. Identical on
/// every platform with IEEE floats.
[[nodiscard]] float spaceNoise(const std::array<float, 3>& position, std::uint32_t seed);

} // namespace lichen::exemplars
