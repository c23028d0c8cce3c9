// SPDX-License-Identifier: MIT
// The sRGB transfer functions against the closed form of IEC 61966-2-1 in double precision.
#include <lichen/image.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace lichen;

namespace {

double lightOf(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

double codeOf(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

// Both functions are a few float operations and one pow of less than 1 ulp; the power 2.4
// multiplies the relative error of its argument by 2.4.
constexpr double kRelativeTolerance = 8 * std::numeric_limits<float>::epsilon();

} // namespace

TEST_CASE("srgbToLinear() matches the closed form") {
  for (int i = 0; i <= 4000; ++i) {
    const float code = float(i) / 2000.0f; // up to 2: values above 1 follow the same formula
    CHECK(srgbToLinear(code) == Approx(lightOf(double(code))).epsilon(kRelativeTolerance));
  }
}

TEST_CASE("linearToSrgb() matches the closed form") {
  for (int i = 0; i <= 4000; ++i) {
    const float light = float(i) / 2000.0f;
    CHECK(linearToSrgb(light) ==
          Approx(codeOf(double(light))).epsilon(kRelativeTolerance).margin(1e-7));
  }
}

TEST_CASE("every 8- and 16-bit code survives the round trip through light") {
  for (int code = 0; code <= 65535; ++code) {
    const float back = linearToSrgb(srgbToLinear(float(code) / 65535.0f));
    if (int(back * 65535.0f + 0.5f) != code)
      FAIL("code " << code << " came back as " << back * 65535.0f);
  }
}

TEST_CASE("converting an image is bit-identical to converting values, and keeps alpha") {
  for (const int channels : {1, 2, 3, 4}) {
    SrgbImage image(16, 16, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i)
      // 8-bit codes, values between them, and values outside [0, 1].
      image.values[i] = i % 3 == 0 ? float(i % 256) / 255.0f : float(i) / 300.0f - 0.5f;
    const LinearImage linear = toLinear(image);
    const SrgbImage back = toSrgb(linear);
    REQUIRE(linear.width == 16);
    REQUIRE(linear.height == 16);
    REQUIRE(linear.channels == channels);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
      const bool alpha = channels % 2 == 0 && int(i) % channels == channels - 1;
      const float value = image.values[i];
      CHECK(linear.values[i] == (alpha ? value : srgbToLinear(value)));
      CHECK(back.values[i] == (alpha ? value : linearToSrgb(linear.values[i])));
    }
  }
}
