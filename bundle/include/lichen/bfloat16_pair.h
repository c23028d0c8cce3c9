// SPDX-License-Identifier: MIT
// Two numbers in the bits of one float: a texel of four floats holds eight.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace lichen {

/// The upper half of a float's bits, rounded to nearest: 8 significant bits, a float's range.
/// Neither infinite nor NaN for |value| up to 3e38.
[[nodiscard]] inline std::uint32_t bfloat16(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return (bits + 0x7FFFu + (bits >> 16 & 1u)) >> 16;
}

/// `first` in the upper half, `second` in the lower. The float is normal or 0, as devices may flush
/// others to 0: a `first` of 0 becomes the smallest normal number, 1.2e-38, if `second` is not 0.
[[nodiscard]] inline float bfloat16Pair(float first, float second) {
  constexpr std::uint32_t kExponent = 0x7F80u, kSmallest = 0x0080u;
  std::uint32_t upper = bfloat16(first), lower = bfloat16(second);
  if ((lower & kExponent) == 0)
    lower = 0;
  if ((upper & kExponent) == 0)
    upper = lower == 0 ? 0 : kSmallest;
  return std::bit_cast<float>(upper << 16 | lower);
}

/// The two numbers of bfloat16Pair(), as lichenBfloat16Pair in the shaders.
[[nodiscard]] inline std::array<float, 2> fromBfloat16Pair(float pair) {
  const auto bits = std::bit_cast<std::uint32_t>(pair);
  return {std::bit_cast<float>(bits & 0xFFFF0000u), std::bit_cast<float>(bits << 16)};
}

} // namespace lichen
