// SPDX-License-Identifier: MIT
// The environment on the CPU: prefiltering a panorama conserves energy.
#include "../unit/temporary_folder.h"
#include "environment.h"
#include "lighting.h"
#include "shaders/scene_interface.h"
#include "sky.h"
#include "sky_cache.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>
#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

using namespace lichen;
using namespace lichen::renderer;

namespace {

LinearImage whitePanorama(int width, int height) {
  LinearImage white(width, height, 3);
  std::fill(white.values.begin(), white.values.end(), 1.0f);
  return white;
}

bool isWhite(const CubeLevel& level) {
  return std::all_of(level.texels.begin(), level.texels.end(), [](glm::vec3 texel) {
    return glm::all(glm::lessThan(glm::abs(texel - 1.0f), glm::vec3(1e-5f)));
  });
}

} // namespace

TEST_CASE("a white panorama is white for every roughness and normal, whatever its shape") {
  for (const auto& [width, height] : {std::pair(64, 32), {1, 1}, {1, 37}, {64, 1}, {5, 4}}) {
    INFO(width << " x " << height);
    const Environment environment = prepareEnvironment(whitePanorama(width, height));
    CHECK(std::ranges::all_of(environment.specular, isWhite));
    CHECK(isWhite(environment.diffuse));
  }
}

TEST_CASE("a note says if a panorama is not twice as wide as high") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "sky.exr";
  std::vector<std::string> notes;
  REQUIRE(writeImage(path, whitePanorama(64, 32)));
  REQUIRE(readPanorama(path, notes));
  CHECK(notes.empty());
  REQUIRE(writeImage(path, whitePanorama(64, 64)));
  REQUIRE(readPanorama(path, notes));
  REQUIRE(notes.size() == 1);
  CHECK(notes.front().starts_with(path.string() + ": 64 x 64 pixels; a panorama of the whole "));
}

TEST_CASE("fitInto() halves a panorama by averaging until it fits") {
  LinearImage ramp(16, 4, 3);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c)
        ramp.pixel(x, y)[c] = float(x + 100 * y + 1000 * c);
  const LinearImage small = fitInto(ramp, 5);
  REQUIRE(small.width == 4);
  REQUIRE(small.height == 1);
  for (int x = 0; x < 4; ++x) // means of 4 x 4 pixels: 4 x + 1.5 in x, 1.5 in y
    CHECK(small.pixel(x, 0)[1] == Approx(4 * x + 1.5 + 150 + 1000));
  CHECK(fitInto(ramp, 16).values == ramp.values);
  CHECK(fitInto(whitePanorama(300, 1), 128).width == 75);
  CHECK(fitInto(whitePanorama(1, 300), 128).height == 75);
}

TEST_CASE("the diffuse cube map is irradiance over pi") {
  // Radiance 1 + y: the irradiance of a normal n is pi (1 + 2/3 n.y) in closed form.
  LinearImage panorama(128, 64, 3);
  for (int y = 0; y < panorama.height; ++y)
    for (int x = 0; x < panorama.width; ++x)
      for (int c = 0; c < 3; ++c)
        panorama.pixel(x, y)[c] =
            1.0f + panoramaDirection({(float(x) + 0.5f) / 128.0f, (float(y) + 0.5f) / 64.0f}).y;
  const CubeLevel diffuse = prepareEnvironment(panorama).diffuse;
  const auto texel = [&](int face) { // nearest to the face's centre
    const auto side = std::size_t(diffuse.side);
    return diffuse.texels[std::size_t(face) * side * side + side / 2 * side + side / 2].x;
  };
  CHECK(texel(2) == Approx(1.0 + 2.0 / 3.0).epsilon(0.01)); // +y
  CHECK(texel(3) == Approx(1.0 - 2.0 / 3.0).epsilon(0.02)); // -y
  CHECK(texel(0) == Approx(1.0).epsilon(0.06)); // +x; the centre texel is off by half a texel
}

namespace {

/// A bright spot of a few degrees on a gradient; no filter is exact on it by symmetry.
LinearImage unevenPanorama() {
  const glm::vec3 spot = glm::normalize(glm::vec3(0.4f, 0.5f, -0.7f));
  constexpr float kSharpness = 200.0f; // falls to 1/e at 6 degrees
  LinearImage image(256, 128, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::vec3 d =
          panoramaDirection({(float(x) + 0.5f) / 256.0f, (float(y) + 0.5f) / 128.0f});
      const float value = 0.5f + 0.3f * d.x + 0.1f * d.y +
                          10.0f * std::exp(kSharpness * (glm::dot(d, spot) - 1.0f));
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = value;
    }
  return image;
}

/// The panorama under the GGX lobe around an axis, weighted by the cosine, as a sum over its
/// texels.
double directIntegral(const LinearImage& panorama, glm::vec3 axis, float alpha) {
  const double a2 = double(alpha) * alpha;
  double sum = 0.0, weights = 0.0;
  for (int y = 0; y < panorama.height; ++y) {
    const double solidAngle = std::sin(std::numbers::pi * (y + 0.5) / panorama.height);
    for (int x = 0; x < panorama.width; ++x) {
      const glm::vec3 light = panoramaDirection(
          {(float(x) + 0.5f) / float(panorama.width), (float(y) + 0.5f) / float(panorama.height)});
      const double cosine = glm::dot(axis, light);
      if (cosine <= 0.0)
        continue;
      const double nDotH = glm::dot(axis, glm::normalize(axis + light));
      const double d = nDotH * nDotH * (a2 - 1.0) + 1.0;
      const double weight = solidAngle * cosine / (d * d);
      sum += weight * double(panorama.pixel(x, y)[0]);
      weights += weight;
    }
  }
  return sum / weights;
}

/// Direction of a texel of a cube map's face [Vulkan 1.3, table "Cube map face and coordinate
/// selection"].
glm::vec3 faceDirection(int face, int side, int x, int y) {
  const float a = (2.0f * float(x) + 1.0f) / float(side) - 1.0f;
  const float b = (2.0f * float(y) + 1.0f) / float(side) - 1.0f;
  const glm::vec3 directions[] = {{1, -b, -a}, {-1, -b, a}, {a, 1, b},
                                  {a, -1, -b}, {a, -b, 1},  {-a, -b, -1}};
  return glm::normalize(directions[face]);
}

} // namespace

TEST_CASE("each specular level is the integral over its lobe") {
  // For 48 samples per lobe; measured 0.025 and 0.083 at roughness 1. The spot is 20 times as
  // bright as its surroundings.
  constexpr double kMeanError = 0.03;
  constexpr double kWorstError = 0.1;
  const LinearImage panorama = unevenPanorama();
  const Environment environment = prepareEnvironment(panorama);
  for (int level = 2; level < kSpecularLevels; ++level) { // sharper lobes are smaller than a texel
    const CubeLevel& cube = environment.specular[std::size_t(level)];
    const float alpha = alphaOf(float(level) / float(kSpecularLevels - 1));
    double worst = 0.0, square = 0.0;
    int count = 0;
    for (int face = 0; face < 6; ++face)
      for (int y = 0; y < cube.side; y += std::max(cube.side / 4, 1))
        for (int x = 0; x < cube.side; x += std::max(cube.side / 4, 1)) {
          const auto texel = std::size_t((face * cube.side + y) * cube.side + x);
          const double exact =
              directIntegral(panorama, faceDirection(face, cube.side, x, y), alpha);
          const double error = std::abs(double(cube.texels[texel].x) - exact) / exact;
          worst = std::max(worst, error);
          square += error * error;
          ++count;
        }
    INFO("level " << level);
    CHECK(std::sqrt(square / count) < kMeanError);
    CHECK(worst < kWorstError);
  }
}

TEST_CASE("no roughness reflects more light than arrives, and a smooth mirror reflects all of it") {
  constexpr int kSide = 16;
  const auto table = environmentBrdf(kSide);
  for (const glm::vec4 value : table) {
    CHECK(value.x >= 0.0f);
    CHECK(value.y >= 0.0f);
    CHECK(value.z >= 0.0f);
    CHECK(value.x + value.y + value.z == Approx(1.0f).epsilon(1e-5));
  }
  CHECK(table[kSide - 1].z < 0.01f);
}

// The multiple-scattering lobe is lossOfLight lossOfView / (pi meanLoss). Its cosine-weighted
// integral over the light is lossOfView, exactly the missing energy, if meanLoss is the mean of the
// stored losses.
TEST_CASE("multiple scattering restores the energy that a white metal loses at any roughness") {
  const auto half = [](float value) {
    return double(glm::unpackHalf1x16(glm::packHalf1x16(value)));
  };
  const auto table = environmentBrdf(kBrdfSide);
  constexpr double kTolerance = 0.002; // halves have 11 bits, and the sum has 32 terms
  constexpr double kLeastHalf = 6e-8;  // smallest positive half
  for (int y = 0; y < kBrdfSide; ++y) {
    const glm::vec4* row = &table[std::size_t(y * kBrdfSide)];
    double back = 0.0;
    for (int x = 0; x < kBrdfSide; ++x)
      back += 2.0 * (x + 0.5) / kBrdfSide * half(row[x].z) / kBrdfSide;
    INFO("roughness " << (y + 0.5) / kBrdfSide);
    CHECK(back == Approx(half(row[0].w)).epsilon(kTolerance).margin(kLeastHalf));
  }
}

TEST_CASE("the sky has the requested irradiance on level ground") {
  for (const float height : {0.1f, 0.5f, 0.9f}) {
    const glm::vec3 towardSun(std::sqrt(1.0f - height * height), height, 0.0f);
    const Sky made = makeSky(towardSun, glm::vec3(0.0f), 2.0f, 128);
    const LinearImage& sky = made.panorama;
    // Independent quadrature: equal steps in azimuth and in sine squared, so that all samples have
    // the same irradiance.
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

TEST_CASE("panorama coordinates and directions are inverses of each other") {
  for (float u = 0.05f; u < 1.0f; u += 0.1f)
    for (float v = 0.05f; v < 1.0f; v += 0.1f) {
      const glm::vec2 back = panoramaCoordinate(panoramaDirection({u, v}));
      CHECK(back.x == Approx(u).margin(1e-5));
      CHECK(back.y == Approx(v).margin(1e-5));
    }
}

TEST_CASE("lights keep their ratios but not their unit") {
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

TEST_CASE("a lamp inside the subject is as strong as one at its border") {
  Scene scene;
  Light lamp;
  lamp.kind = LightKind::point;
  scene.lights = {lamp, lamp};
  scene.lights[1].position = {0.0, 2.0, 0.0};
  const auto brightest = [&](double x) {
    scene.lights[0].position = {x, 0.0, 0.0};
    return arrangeLights(scene, {}, false).lights[0].intensity; // the subject has a radius of 1
  };
  CHECK(brightest(0.01) == brightest(1.0));
  CHECK(brightest(1.5) == Approx(2.25f * brightest(1.0)));
}

TEST_CASE("with too many lights, the sun and the strongest ones at the subject remain") {
  Scene scene;
  constexpr int kLamps = 40;
  for (int i = 0; i < kLamps; ++i) {
    Light lamp;
    lamp.kind = LightKind::point;
    lamp.position = {0.0, 0.0, 10.0 + i};
    scene.lights.insert(scene.lights.begin(), lamp);
  }
  Light sun;
  sun.intensity = 1e-6f;
  scene.lights.push_back(sun);
  const Lighting lighting = arrangeLights(scene, {}, false);
  REQUIRE(lighting.lights.size() == MAX_LIGHTS);
  CHECK(lighting.dropped == kLamps + 1 - MAX_LIGHTS);
  CHECK(lighting.hasSun);
  CHECK(lighting.lights[0].kind == LightKind::directional);
  for (std::size_t i = 1; i < MAX_LIGHTS; ++i) // the nearest ones
    CHECK(lighting.lights[i].position.z < 10.0 + MAX_LIGHTS);
}

TEST_CASE("a light whose inverse overflows a float still counts") {
  Scene scene;
  Light faint;
  faint.intensity = 1e-42f;
  scene.lights = {faint};
  CHECK(arrangeLights(scene, {}, false).lights[0].intensity ==
        Approx(1.05 * std::numbers::pi).epsilon(0.01));
}

TEST_CASE("an environment file is the only light of a scene without lights") {
  const Lighting lighting = arrangeLights(Scene(), {}, true);
  CHECK(lighting.lights.empty());
  CHECK(lighting.skyIrradiance == 0.0f);
  CHECK(arrangeLights(Scene(), {}, false).hasSun);
}

TEST_CASE("the cached sky is reused until its light changes") {
  SkyCache skies;
  const glm::vec3 above(0.0f, 1.0f, 0.0f);
  const glm::vec3 sunlight(3.0f);
  const auto diffuse = [&](float irradiance) {
    return skies.prepare(above, sunlight, irradiance).environment.diffuse.texels;
  };
  const std::vector<glm::vec3> bright = diffuse(1.0f);
  CHECK(diffuse(1.0f) == bright);
  const std::vector<glm::vec3> dim = diffuse(0.5f);
  for (std::size_t i = 0; i < dim.size(); ++i)
    CHECK(dim[i] != bright[i]);
}
