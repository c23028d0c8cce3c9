// SPDX-License-Identifier: MIT
// Images with their encoding as part of the type.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lichen {

/// What a stored value means. The encoding is part of an image's type, so linear light and sRGB
/// codes never mix without an explicit conversion.
enum class Encoding {
  srgb,   ///< IEC 61966-2-1 code values; [0, 1] is the displayable range
  linear, ///< values proportional to light, or plain data (slopes, heights, roughness)
};

/// A width x height image of interleaved float channels, row 0 at the top: value (x, y, c) is
/// values[(y * width + x) * channels + c]. May throw std::bad_alloc.
template <Encoding kEncoding>
struct Image {
  static constexpr Encoding encoding = kEncoding;

  int width = 0;
  int height = 0;
  int channels = 0; ///< [1, 4]; 2 is grey + alpha, 4 is RGB + alpha in files
  std::vector<float> values;

  Image() = default;
  Image(int w, int h, int c)
      : width(w), height(h), channels(c),
        values(std::size_t(w) * std::size_t(h) * std::size_t(c), 0.0f) {}

  [[nodiscard]] std::size_t pixelCount() const { return std::size_t(width) * std::size_t(height); }
  [[nodiscard]] float* pixel(int x, int y) {
    return values.data() +
           (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels);
  }
  [[nodiscard]] const float* pixel(int x, int y) const {
    return values.data() +
           (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels);
  }
};

using SrgbImage = Image<Encoding::srgb>;
using LinearImage = Image<Encoding::linear>;

/// Converts two-channel data to red and green, because files interpret two channels as grey and
/// alpha. Returns other images unchanged, reusing their storage.
template <Encoding kEncoding>
[[nodiscard]] Image<kEncoding> twoAsRedGreen(Image<kEncoding> image) {
  if (image.channels != 2)
    return image;
  Image<kEncoding> rgb(image.width, image.height, 3);
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    std::copy_n(&image.values[2 * i], 2, &rgb.values[3 * i]);
  return rgb;
}

/// IEC 61966-2-1 transfer functions, extended by the same formula above 1 and by odd symmetry below
/// 0. They are inverses of each other up to rounding.
[[nodiscard]] float srgbToLinear(float code);
[[nodiscard]] float linearToSrgb(float light);

/// Converts the colour channels; alpha (the last of 2 or 4 channels) is unchanged. Reuses the
/// argument's storage, so an image moved in is converted in place.
[[nodiscard]] LinearImage toLinear(SrgbImage image);
[[nodiscard]] SrgbImage toSrgb(LinearImage image);

} // namespace lichen
