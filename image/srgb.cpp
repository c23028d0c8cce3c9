// SPDX-License-Identifier: MIT
// The sRGB transfer functions of IEC 61966-2-1, for values and images.
#include <lichen/image.h>

#include <array>
#include <cmath>
#include <utility>

namespace lichen {
namespace {

// IEC 61966-2-1: linear with slope 12.92 near black, a power of 2.4 with offset 0.055 above.
constexpr float kLinearSlope = 12.92f;
constexpr float kPower = 2.4f;
constexpr double kOffset = 0.055; // in double, so that 1 maps exactly to 1
constexpr float kCodeBreak = 0.04045f;
constexpr float kLightBreak = 0.0031308f;

constexpr float kLargestCode = 255.0f; // of an 8-bit file

/// Linear light of every 8-bit code. Most exemplars are 8-bit files, and pow() is slow.
std::array<float, 256> tabulateLight() {
  std::array<float, 256> table;
  for (std::size_t code = 0; code < table.size(); ++code)
    table[code] = srgbToLinear(float(code) / kLargestCode);
  return table;
}

/// Bit-identical to srgbToLinear(code), but faster if code is a multiple of 1/255.
float srgbToLinearByTable(float code) {
  static const std::array<float, 256> table = tabulateLight();
  if (code >= 0.0f && code <= 1.0f) {
    const auto nearest = std::size_t(code * kLargestCode + 0.5f);
    if (float(nearest) / kLargestCode == code)
      return table[nearest];
  }
  return srgbToLinear(code);
}

template <class Target, class Source, class Function>
Target convertColour(Source image, Function convert) {
  Target result;
  result.width = image.width;
  result.height = image.height;
  result.channels = image.channels;
  result.values = std::move(image.values);
  const auto channels = std::size_t(result.channels);
  const std::size_t colours = channels % 2 == 0 ? channels - 1 : channels;
  for (std::size_t i = 0; i < result.values.size(); i += channels)
    for (std::size_t c = 0; c < colours; ++c)
      result.values[i + c] = convert(result.values[i + c]);
  return result;
}

} // namespace

float srgbToLinear(float code) {
  const float magnitude = std::abs(code);
  const float light =
      magnitude <= kCodeBreak
          ? magnitude / kLinearSlope
          : std::pow(float((double(magnitude) + kOffset) / (1.0 + kOffset)), kPower);
  return std::copysign(light, code);
}

float linearToSrgb(float light) {
  const float magnitude = std::abs(light);
  const float code =
      magnitude <= kLightBreak
          ? magnitude * kLinearSlope
          : float((1.0 + kOffset) * double(std::pow(magnitude, 1.0f / kPower)) - kOffset);
  return std::copysign(code, light);
}

LinearImage toLinear(SrgbImage image) {
  return convertColour<LinearImage>(std::move(image), srgbToLinearByTable);
}

SrgbImage toSrgb(LinearImage image) {
  return convertColour<SrgbImage>(std::move(image), linearToSrgb);
}

} // namespace lichen
