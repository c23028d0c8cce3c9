// SPDX-License-Identifier: MIT
// Texel formats: encoding and decoding against their definitions.
#include <lichen/bundle.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace lichen;

namespace {

std::vector<float> throughFormat(TexelFormat format, const std::vector<float>& values) {
  const auto channels = std::uint32_t(channelCount(format));
  Table table{"", format, std::uint32_t(values.size()) / channels, 1, 0, 1, {}};
  appendTexels(table.texels, format, values);
  return decodeLevel(table, 0);
}

/// The value of a half float by the formula of IEEE 754: sign, exponent, mantissa.
double valueOfHalf(unsigned half) {
  const double sign = half & 0x8000u ? -1.0 : 1.0;
  const int exponent = int(half >> 10u & 31u);
  const double mantissa = half & 1023u;
  return exponent == 0 ? sign * std::ldexp(mantissa, -24)
                       : sign * std::ldexp(1024.0 + mantissa, exponent - 25);
}

} // namespace

TEST_CASE("a float becomes the nearest half, and every finite half keeps its value") {
  for (unsigned half = 0; half < 0x10000u; ++half) {
    if ((half & 0x7c00u) == 0x7c00u)
      continue;
    const auto value = float(valueOfHalf(half));
    REQUIRE(throughFormat(TexelFormat::r16Sfloat, {value})[0] == value);
    if ((half & 0x7fffu) == 0x7bffu) // the largest has no neighbour
      continue;
    const double next = valueOfHalf(half + 1);
    const double below = value + 0.49 * (next - double(value));
    const double above = value + 0.51 * (next - double(value));
    const double middle = value + 0.5 * (next - double(value)); // ties go to the even half float
    REQUIRE(throughFormat(TexelFormat::r16Sfloat, {float(below)})[0] == value);
    REQUIRE(throughFormat(TexelFormat::r16Sfloat, {float(above)})[0] == float(next));
    REQUIRE(throughFormat(TexelFormat::r16Sfloat, {float(middle)})[0] ==
            (half % 2 == 0 ? value : float(next)));
  }
  CHECK(throughFormat(TexelFormat::r16Sfloat, {1e9f, -1e9f}) == std::vector<float>{65504, -65504});
}

TEST_CASE("unorm texels are rounded to the nearest code and clamped") {
  CHECK(throughFormat(TexelFormat::r8Unorm, {-1.0f, 0.0f, 0.4999f / 255.0f, 0.5001f / 255.0f,
                                             254.4f / 255.0f, 1.0f, 2.0f}) ==
        std::vector<float>{0.0f, 0.0f, 0.0f, 1.0f / 255.0f, 254.0f / 255.0f, 1.0f, 1.0f});
}

TEST_CASE("mip levels halve, never below one texel, and are stored one after another") {
  const Table table{"", TexelFormat::rg8Unorm, 5, 2, 0, 3, {}};
  CHECK(levelRange(table, 0).offset == 0);
  CHECK(levelRange(table, 0).size == 5 * 2 * 2);
  CHECK(levelRange(table, 1).offset == 20);
  CHECK(levelRange(table, 1).size == 2 * 1 * 2);
  CHECK(levelRange(table, 2).offset == 24);
  CHECK(levelRange(table, 2).size == 2);
  const Table deep{"", TexelFormat::r8Unorm, 5, 2, 4, 3, {}};
  CHECK(levelRange(deep, 0).size == 5 * 2 * 4);
  CHECK(levelRange(deep, 1).offset == 40);
  CHECK(levelRange(deep, 1).size == 2 * 1 * 2);
  CHECK(levelRange(deep, 2).offset == 44);
  CHECK(levelRange(deep, 2).size == 1);
}
