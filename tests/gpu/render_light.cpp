// SPDX-License-Identifier: MIT
// The environment on the CPU: energy is kept, whatever is prepared from a panorama.
#include "environment.h"
#include "lighting.h"
#include "sky.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace lichen;
using namespace lichen::renderer;

TEST_CASE("a white panorama is white to every roughness and every normal") {
  LinearImage white(64, 32, 3);
  std::fill(white.values.begin(), white.values.end(), 1.0f);
  const Environment environment = prepareEnvironment(white);
  const auto isWhite = [](const CubeLevel& level) {
    for (const glm::vec3 texel : level.texels)
      for (int c = 0; c < 3; ++c)
        if (std::abs(texel[c] - 1.0f) > 1e-5f)
          return false;
    return true;
  };
  for (const CubeLevel& level : environment.specular)
    CHECK(isWhite(level));
  CHECK(isWhite(environment.diffuse));
}

TEST_CASE("the matte side of a panorama is its irradiance over pi") {
  // Radiance 1 + y: the irradiance of a normal n is pi (1 + 2/3 n.y) in closed form.
  LinearImage panorama(128, 64, 3);
  for (int y = 0; y < panorama.height; ++y)
    for (int x = 0; x < panorama.width; ++x)
      for (int c = 0; c < 3; ++c)
        panorama.pixel(x, y)[c] =
            1.0f + panoramaDirection({(float(x) + 0.5f) / 128.0f, (float(y) + 0.5f) / 64.0f}).y;
  const CubeLevel diffuse = prepareEnvironment(panorama).diffuse;
  const auto texel = [&](int face) { // nearest to its centre
    const auto side = std::size_t(diffuse.side);
    return diffuse.texels[std::size_t(face) * side * side + side / 2 * side + side / 2].x;
  };
  CHECK(texel(2) == Approx(1.0 + 2.0 / 3.0).epsilon(0.01)); // +y
  CHECK(texel(3) == Approx(1.0 - 2.0 / 3.0).epsilon(0.02)); // -y
  CHECK(texel(0) == Approx(1.0).epsilon(0.06)); // +x; the centre texel leans by half a texel
}

TEST_CASE("no roughness reflects more than it gets, and a smooth mirror all of it") {
  constexpr int kSide = 16;
  const auto table = environmentBrdf(kSide);
  for (const glm::vec2 value : table) {
    CHECK(value.x >= 0.0f);
    CHECK(value.y >= 0.0f);
    CHECK(value.x + value.y <= 1.01f); // of 256 samples
  }
  CHECK(table[kSide - 1].x + table[kSide - 1].y == Approx(1.0f).epsilon(0.01));
}

TEST_CASE("the sky lays the light on level ground that was asked for") {
  for (const float height : {0.1f, 0.5f, 0.9f}) {
    const glm::vec3 towardSun(std::sqrt(1.0f - height * height), height, 0.0f);
    const Sky made = makeSky(towardSun, glm::vec3(0.0f), 2.0f, 128);
    const LinearImage& sky = made.panorama;
    // Independent quadrature: equal steps of azimuth and of sine squared, so that each sample
    // stands for the same irradiance.
    double sum = 0.0;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps; ++i)
      for (int j = 0; j < kSteps; ++j) {
        const double sine = std::sqrt((i + 0.5) / kSteps);
        const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / kSteps;
        const double up = std::sqrt(1.0 - sine * sine);
        const glm::vec2 uv = panoramaCoordinate(
            {float(sine * std::cos(azimuth)), float(up), float(sine * std::sin(azimuth))});
        const float* p = sky.pixel(std::min(int(uv.x * 256), 255), std::min(int(uv.y * 128), 127));
        sum += (p[0] + p[1] + p[2]) / 3.0;
      }
    CHECK(sum * std::numbers::pi / (kSteps * kSteps) == Approx(2.0).epsilon(0.02));
  }
}

TEST_CASE("sun and sky together are neutral on level ground") {
  const glm::vec3 towardSun(0.0f, 0.6f, 0.8f);
  const glm::vec3 sunlight(3.0f, 2.8f, 2.5f);
  const Sky sky = makeSky(towardSun, sunlight, 1.0f, 64);
  const CubeLevel diffuse = prepareEnvironment(sky.panorama).diffuse;
  const auto side = std::size_t(diffuse.side);
  const glm::vec3 up = diffuse.texels[2 * side * side + side / 2 * side + side / 2];
  const glm::vec3 total = std::numbers::pi_v<float> * up + sunlight * sky.balance * towardSun.y;
  CHECK(total.r == Approx(total.g).epsilon(0.01));
  CHECK(total.b == Approx(total.g).epsilon(0.01));
}

TEST_CASE("panorama coordinates and directions are inverse to each other") {
  for (float u = 0.05f; u < 1.0f; u += 0.1f)
    for (float v = 0.05f; v < 1.0f; v += 0.1f) {
      const glm::vec2 back = panoramaCoordinate(panoramaDirection({u, v}));
      CHECK(back.x == Approx(u).margin(1e-5));
      CHECK(back.y == Approx(v).margin(1e-5));
    }
}

TEST_CASE("lights keep their ratios and lose their unit") {
  Scene scene;
  Light sun;
  sun.intensity = 100000.0f;
  Light fill;
  fill.intensity = 25000.0f;
  scene.lights = {fill, sun};
  const Lighting bright = arrangeLights(scene, {}, false);
  scene.lights = {sun, fill};
  for (Light& light : scene.lights)
    light.intensity *= 1e-4f;
  const Lighting dim = arrangeLights(scene, {}, false);
  REQUIRE(bright.lights.size() == 2);
  CHECK(bright.hasSun);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(bright.lights[i].intensity == Approx(dim.lights[i].intensity));
  CHECK(bright.lights[0].intensity == Approx(4.0f * bright.lights[1].intensity));
}

TEST_CASE("an environment file is all the light of a scene without lights") {
  const Lighting lighting = arrangeLights(Scene(), {}, true);
  CHECK(lighting.lights.empty());
  CHECK(lighting.skyIrradiance == 0.0f);
  CHECK(arrangeLights(Scene(), {}, false).hasSun);
}
