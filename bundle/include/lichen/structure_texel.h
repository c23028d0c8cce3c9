// SPDX-License-Identifier: MIT
// The texels of a structure: three integers in the bits of one float.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace lichen {

/// The largest integer; the least that is written is its negative.
inline constexpr int kMostStructureInteger = 511;

/// Three integers of ten bits. The float is normal, as devices may flush others to 0: its exponent
/// begins with the bits 01.
[[nodiscard]] inline float structureTexel(const std::array<int, 3>& integers) {
  const auto bits = [](int integer) { return std::uint32_t(integer) & 0x3FFu; };
  const std::uint32_t third = bits(integers[2]);
  return std::bit_cast<float>(0x20000000u | (third & 0x200u) << 22 | (third & 0x1FFu) << 20 |
                              bits(integers[1]) << 10 | bits(integers[0]));
}

/// The integers of structureTexel(), as lichenStructureTexel in the shaders. Each is within [-512,
/// 511], whatever the float.
[[nodiscard]] inline std::array<int, 3> fromStructureTexel(float texel) {
  const auto bits = std::bit_cast<std::uint32_t>(texel);
  const auto upper = [](std::uint32_t word) { return int(std::int32_t(word) >> 22); };
  return {upper(bits << 22), upper(bits << 12),
          upper((bits & 0x80000000u) | (bits << 2 & 0x7FC00000u))};
}

} // namespace lichen
