// SPDX-License-Identifier: MIT
// Texel formats of a table: bytes per texel and mip level, texels to floats and back. Texel (x, y,
// z) of a mip level starts at byte ((z * height + y) * width + x) * texelBytes(format).
// Source: IEEE 754-2008 binary16.
#include <lichen/bundle.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>

namespace lichen {
namespace {

enum class Component { unorm8, half, single };

Component componentOf(TexelFormat format) {
  switch (format) {
  case TexelFormat::r16Sfloat:
  case TexelFormat::rg16Sfloat:
  case TexelFormat::rgba16Sfloat:
    return Component::half;
  case TexelFormat::r32Sfloat:
  case TexelFormat::rgba32Sfloat:
    return Component::single;
  default:
    return Component::unorm8;
  }
}

std::size_t componentBytes(TexelFormat format) {
  switch (componentOf(format)) {
  case Component::half:
    return 2;
  case Component::single:
    return 4;
  default:
    return 1;
  }
}

constexpr float kUnorm8Max = 255.0f;

// binary16 has 5 exponent bits with bias 15 and 10 mantissa bits; binary32 has 8 with bias 127 and
// 23. A subnormal half is an integer multiple of 2^-24.

/// Rounds to nearest, ties to even. Precondition: |value| <= kHalfMax.
std::uint16_t halfFromFloat(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = (bits >> 16u) & 0x8000u;
  constexpr float kSmallestNormalHalf = 0x1p-14f;
  if (std::abs(value) < kSmallestNormalHalf) // the default rounding mode is to nearest even
    return std::uint16_t(sign | std::uint32_t(std::nearbyint(std::abs(value) * 0x1p24f)));
  const std::uint32_t rebiased = (bits & 0x7fffffffu) - ((127u - 15u) << 23u);
  const std::uint32_t roundUp = 0xfffu + ((rebiased >> 13u) & 1u);
  return std::uint16_t(sign | ((rebiased + roundUp) >> 13u));
}

/// Precondition: `half` is finite.
float floatFromHalf(std::uint16_t half) {
  const std::uint32_t sign = std::uint32_t(half & 0x8000u) << 16u;
  const std::uint32_t magnitude = half & 0x7fffu;
  constexpr std::uint32_t kSmallestNormalBits = 0x400u;
  const float value = magnitude < kSmallestNormalBits
                          ? float(magnitude) * 0x1p-24f
                          : std::bit_cast<float>((magnitude << 13u) + ((127u - 15u) << 23u));
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) | sign);
}

} // namespace

int channelCount(TexelFormat format) {
  switch (format) {
  case TexelFormat::r8Unorm:
  case TexelFormat::r16Sfloat:
  case TexelFormat::r32Sfloat:
    return 1;
  case TexelFormat::rg8Unorm:
  case TexelFormat::rg16Sfloat:
    return 2;
  default:
    return 4;
  }
}

std::size_t texelBytes(TexelFormat format) {
  return componentBytes(format) * std::size_t(channelCount(format));
}

std::size_t texelBytes(const Bundle& bundle) {
  std::size_t sum = 0;
  for (const Table& table : bundle.tables)
    sum += table.texels.size();
  return sum;
}

LevelRange levelRange(const Table& table, std::uint32_t level) {
  assert(level < table.mipLevels);
  LevelRange range;
  for (std::uint32_t l = 0;; ++l) {
    const auto side = [l](std::uint32_t size) { return std::size_t(std::max(1u, size >> l)); };
    range.size =
        side(table.width) * side(table.height) * side(table.depth) * texelBytes(table.format);
    if (l == level)
      return range;
    range.offset += range.size;
  }
}

bool hasFiniteTexels(const Table& table) {
  const Component component = componentOf(table.format);
  const std::span<const std::byte> bytes = table.texels;
  // NaN and infinity have all exponent bits set.
  const auto hasOnly = [&]<class Word>(Word exponent) {
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(Word)) {
      Word word = 0;
      std::memcpy(&word, bytes.data() + i, sizeof word);
      if ((word & exponent) == exponent)
        return false;
    }
    return true;
  };
  if (component == Component::half)
    return hasOnly(std::uint16_t(0x7c00u));
  return component == Component::unorm8 || hasOnly(std::uint32_t(0x7f800000u));
}

std::vector<float> decodeLevel(const Table& table, std::uint32_t level) {
  const LevelRange range = levelRange(table, level);
  assert(range.offset + range.size <= table.texels.size());
  const std::size_t bytes = componentBytes(table.format);
  std::vector<float> values(range.size / bytes);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::byte* source = table.texels.data() + range.offset + i * bytes;
    switch (componentOf(table.format)) {
    case Component::unorm8:
      values[i] = float(std::to_integer<int>(*source)) / kUnorm8Max;
      break;
    case Component::half: {
      std::uint16_t half = 0;
      std::memcpy(&half, source, sizeof half);
      values[i] = floatFromHalf(half);
      break;
    }
    case Component::single:
      std::memcpy(&values[i], source, sizeof values[i]);
      break;
    }
  }
  return values;
}

void appendTexels(std::vector<std::byte>& texels, TexelFormat format,
                  std::span<const float> values) {
  const std::size_t bytes = componentBytes(format);
  assert(values.size() % std::size_t(channelCount(format)) == 0);
  std::size_t end = texels.size();
  texels.resize(end + values.size() * bytes);
  for (std::size_t i = 0; i < values.size(); ++i, end += bytes) {
    std::byte* target = texels.data() + end;
    switch (componentOf(format)) {
    case Component::unorm8:
      *target = std::byte(std::lround(std::clamp(values[i], 0.0f, 1.0f) * kUnorm8Max));
      break;
    case Component::half: {
      const std::uint16_t half = halfFromFloat(std::clamp(values[i], -kHalfMax, kHalfMax));
      std::memcpy(target, &half, sizeof half);
      break;
    }
    case Component::single:
      std::memcpy(target, &values[i], sizeof values[i]);
      break;
    }
  }
}

} // namespace lichen
