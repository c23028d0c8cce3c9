// SPDX-License-Identifier: MIT
// Smooth noise in space, of which the example meshes are made.
#pragma once

#include <array>
#include <cstdint>

namespace lichen::exemplars {

/// Values of [-1, 1] at whole places, smooth between them. The same bits wherever IEEE arithmetic
/// is kept.
[[nodiscard]] float spaceNoise(const std::array<float, 3>& place, std::uint32_t seed);

} // namespace lichen::exemplars
