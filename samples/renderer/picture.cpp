// SPDX-License-Identifier: MIT
// Linear pixels -> EXR, or dithered sRGB -> PNG.
#include "picture.h"

#include <lichen/image_io.h>
#include <lichen/lattice.h>

#include <algorithm>

namespace lichen::renderer {
namespace {

constexpr float kCodes = 255.0f;

/// Uniform in [-1/2, 1/2), from a hash of position and channel, so runs are reproducible.
float dither(std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
  const std::uint32_t word = pcg3d({x, y, channel})[0];
  constexpr float kTwoToMinus24 = 1.0f / 16777216.0f;
  return float(word >> 8) * kTwoToMinus24 - 0.5f;
}

} // namespace

Result<void> writePicture(const std::filesystem::path& path, const LinearImage& pixels) {
  if (path.extension() == ".exr")
    return writeImage(path, pixels);
  SrgbImage code = toSrgb(pixels);
  for (int y = 0; y < code.height; ++y)
    for (int x = 0; x < code.width; ++x)
      for (int c = 0; c < code.channels; ++c) {
        // Leave pure black and white undithered.
        float& value = code.pixel(x, y)[c];
        if (value > 0.0f && value < 1.0f)
          value = std::clamp(value + dither(std::uint32_t(x), std::uint32_t(y), std::uint32_t(c)) /
                                         kCodes,
                             0.0f, 1.0f);
      }
  return writeImage(path, code);
}

} // namespace lichen::renderer
