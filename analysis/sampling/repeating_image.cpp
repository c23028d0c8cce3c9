// SPDX-License-Identifier: MIT
// A trilinear, repeating sampler in float precision.
#include "repeating_image.h"

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

using Value = RepeatingImage::Value;

/// Wraps any integer into [0, side), because a texture repeats.
std::size_t wrapped(int k, int side) {
  const int remainder = k % side;
  return std::size_t(remainder < 0 ? remainder + side : remainder);
}

} // namespace

std::vector<Value> texelsOf(const Table& table, std::uint32_t level, Alpha alpha) {
  const std::vector<float> values = decodeLevel(table, level);
  const auto channels = std::size_t(channelCount(table.format));
  std::vector<Value> texels(values.size() / channels, Value{0.0f, 0.0f, 0.0f, 1.0f});
  const std::size_t colors =
      alpha == Alpha::lastChannel ? channels - 1 : std::min<std::size_t>(channels, 3);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    std::copy_n(&values[i * channels], colors, texels[i].begin());
    if (alpha == Alpha::lastChannel)
      texels[i][3] = values[i * channels + colors];
  }
  return texels;
}

RepeatingImage::RepeatingImage(const Table& table, Alpha alpha) {
  for (std::uint32_t level = 0; level < table.mipLevels; ++level)
    mips_.push_back({std::max(1, int(table.width >> level)),
                     std::max(1, int(table.height >> level)), texelsOf(table, level, alpha)});
}

Value RepeatingImage::bilinear(const Mip& mip, float u, float v) {
  const float x = u * float(mip.width) - 0.5f;
  const float y = v * float(mip.height) - 0.5f;
  const float floorX = std::floor(x);
  const float floorY = std::floor(y);
  const std::size_t x0 = wrapped(int(floorX), mip.width);
  const std::size_t y0 = wrapped(int(floorY), mip.height);
  const std::size_t x1 = x0 + 1 == std::size_t(mip.width) ? 0 : x0 + 1;
  const std::size_t y1 = y0 + 1 == std::size_t(mip.height) ? 0 : y0 + 1;
  const auto texel = [&](std::size_t column, std::size_t row) -> const Value& {
    return mip.texels[row * std::size_t(mip.width) + column];
  };
  return mix(mix(texel(x0, y0), texel(x1, y0), x - floorX),
             mix(texel(x0, y1), texel(x1, y1), x - floorX), y - floorY);
}

Value RepeatingImage::at(float u, float v, float lod) const {
  // Keep the integer part small, so that its product with the side loses no fraction.
  u -= std::floor(u);
  v -= std::floor(v);
  const float level = std::clamp(lod, 0.0f, float(mips_.size() - 1));
  const auto fine = std::size_t(level);
  const Value value = bilinear(mips_[fine], u, v);
  const float t = level - float(fine);
  return t > 0.0f ? mix(value, bilinear(mips_[fine + 1], u, v), t) : value;
}

} // namespace lichen
