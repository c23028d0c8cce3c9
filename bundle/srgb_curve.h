// SPDX-License-Identifier: MIT
// The sRGB transfer function, IEC 61966-2-1: code value <-> linear light.
#pragma once

#include <cmath>

namespace lichen {

[[nodiscard]] inline float srgbToLight(float code) {
  return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

[[nodiscard]] inline float lightToSrgb(float light) {
  return light <= 0.0031308f ? light * 12.92f : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
}

} // namespace lichen
