// SPDX-License-Identifier: MIT
// Smooth noise at any point, for the example meshes and the structured materials.
#pragma once

#include <array>
#include <cstdint>

namespace lichen::exemplars {

/// Value noise: random values in [-1, 1] at integer positions, smooth in between. Identical on
/// every platform with IEEE floats.
[[nodiscard]] float spaceNoise(const std::array<float, 3>& position, std::uint32_t seed);

/// The same in the plane. It repeats after `repeat` units along each axis; 0 for never.
[[nodiscard]] float planeNoise(const std::array<float, 2>& position,
                               const std::array<int, 2>& repeat, std::uint32_t seed);

} // namespace lichen::exemplars
