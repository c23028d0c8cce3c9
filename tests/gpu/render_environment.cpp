// SPDX-License-Identifier: MIT
// Environment light: directions of a panorama in the background and in mirrors; energy
// conservation of reflection, on planes under lamps; and the share of the sky that a ball occludes.
#include "rendered.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lichen;
using namespace lichen::test;
using renderer::RenderSettings;

namespace {

constexpr double kPi = std::numbers::pi;

LinearImage black() {
  LinearImage image(2, 1, 3);
  std::fill(image.values.begin(), image.values.end(), 0.0f);
  return image;
}

RenderSettings settingsUnder(LinearImage environment, std::uint32_t side) {
  RenderSettings settings = settingsOf(side, side, 1);
  settings.toneMap = false;
  settings.environment = std::move(environment);
  return settings;
}

/// A panorama with radiance 1/2 + d/2 from direction d, one colour per axis: +y in the top row, -z
/// in the middle, +x to its right.
LinearImage directions() {
  LinearImage image(256, 128, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double polar = kPi * (y + 0.5) / image.height;
      const double azimuth = 2.0 * kPi * ((x + 0.5) / image.width - 0.5);
      const std::array direction{std::sin(azimuth) * std::sin(polar), std::cos(polar),
                                 -std::cos(azimuth) * std::sin(polar)};
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = float(0.5 + 0.5 * direction[std::size_t(c)]);
    }
  return image;
}

constexpr float kFieldOfView = 1.2f;
constexpr float kDistance = 4.0f;

/// A mirror ball and a camera at +z that looks along -z.
GltfScene mirrorBall() {
  GltfScene scene;
  scene.addBall(scene.addMaterial(
      {{"pbrMetallicRoughness", {{"metallicFactor", 1}, {"roughnessFactor", 0}}}}));
  scene.addCamera(kDistance, kFieldOfView);
  return scene;
}

/// A square that faces the camera, with a normal of its own.
struct Plate {
  glm::dvec3 normal;
  double metallic = 1.0;
  double roughness = 1.0;
};

constexpr glm::dvec3 kView{0.0, 0.0, 1.0}; // toward the camera
/// lighting.cpp's kKeyIrradiance: irradiance of each of several equal lamps on a surface that faces
/// it.
constexpr double kLampIrradiance = 1.05 * kPi;

void addPlate(GltfScene& scene, const Plate& plate, float left) {
  const auto n = glm::vec3(plate.normal);
  scene.addMesh(
      {{"POSITION", scene.addFloats({left, 0, 0, left + 1, 0, 0, left + 1, 1, 0, left, 1, 0}, 3)},
       {"NORMAL",
        scene.addFloats({n.x, n.y, n.z, n.x, n.y, n.z, n.x, n.y, n.z, n.x, n.y, n.z}, 3)}},
      scene.addIndices({0, 1, 2, 0, 2, 3}, 1),
      scene.addMaterial(
          {{"pbrMetallicRoughness",
            {{"metallicFactor", plate.metallic}, {"roughnessFactor", plate.roughness}}}}));
}

void addNode(GltfScene& scene, nlohmann::json node) {
  nlohmann::json& nodes = scene.json["nodes"];
  nodes.push_back(std::move(node));
  scene.json["scenes"][0]["nodes"].push_back(nodes.size() - 1);
}

/// A camera that sees this many plates.
void addPlateCamera(GltfScene& scene, int count) {
  scene.json["cameras"] = {
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", count / 2.0}, {"ymag", 0.5}, {"znear", 0.1}, {"zfar", 2}}}}};
  addNode(scene, {{"camera", 0}, {"translation", {0.0, 0.5, 1.0}}});
  scene.json["extensionsUsed"] = {"KHR_lights_punctual"};
}

void addLamp(GltfScene& scene, int light, const glm::dvec3& at) {
  addNode(scene, {{"translation", {at.x, at.y, at.z}},
                  {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
}

/// Radiance of each plate under equal lamps in these directions, relative to the irradiance of one
/// lamp. The lamps are distant point lights, so their light is parallel, and point lights cast no
/// shadows.
std::vector<double> radiances(const std::vector<Plate>& plates,
                              const std::vector<glm::dvec3>& lamps) {
  const auto count = int(plates.size());
  GltfScene scene;
  for (int i = 0; i < count; ++i)
    addPlate(scene, plates[std::size_t(i)], float(i) - float(count) / 2.0f);
  addPlateCamera(scene, count);
  scene.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  for (const glm::dvec3 lamp : lamps)
    addLamp(scene, 0, 1e5 * lamp);
  RenderSettings settings = settingsUnder(black(), 1);
  settings.width = std::uint32_t(count);
  const LinearImage picture = render(scene.glb(), settings);
  std::vector<double> result;
  for (int i = 0; i < count; ++i)
    result.push_back(double(picture.pixel(i, 0)[1]) / kLampIrradiance);
  return result;
}

constexpr float kBallHeight = 1.5f;
constexpr float kGroundHalf = 2.9f;

/// A white ball on a white ground that fills the picture, from above.
GltfScene ballFromAbove() {
  GltfScene scene;
  const std::size_t white = scene.addMaterial(
      {{"pbrMetallicRoughness", {{"metallicFactor", 1}, {"roughnessFactor", 1}}}});
  scene.addBall(white, {{"translation", {0, kBallHeight, 0}}});
  scene.addGround(white, kGroundHalf, 0.0f);
  scene.json["cameras"] = {
      {{"type", "orthographic"},
       {"orthographic",
        {{"xmag", kGroundHalf}, {"ymag", kGroundHalf}, {"znear", 0.1}, {"zfar", 9}}}}};
  scene.json["nodes"].push_back({{"camera", 0},
                                 {"translation", {0, 5, 0}},
                                 {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}});
  scene.json["scenes"][0]["nodes"].push_back(scene.json["nodes"].size() - 1);
  return scene;
}

/// The share of a uniform sky's light that reaches level ground at this distance from a ball of
/// radius 1: the ball occludes the cosine over its squared distance. The sky's lowest 0.12 are
/// never sampled (frame_data.cpp); they have 0.12 squared of the light.
double lightBeside(double across) {
  const double distance = std::hypot(across, double(kBallHeight));
  return 1.0 - kBallHeight / (distance * distance * distance) / (1.0 - 0.12 * 0.12);
}

} // namespace

TEST_CASE("background and mirror show the panorama in the right direction") {
  // A texel covers 1/256 of a full turn, and values are half floats.
  constexpr double kTolerance = 0.01;
  constexpr int kSide = 48;
  const LinearImage picture = render(mirrorBall().glb(), settingsUnder(directions(), kSide));
  const double half = std::tan(kFieldOfView / 2.0);
  std::size_t background = 0, mirrored = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      glm::dvec3 d = glm::normalize(glm::dvec3((2.0 * (x + 0.5) / kSide - 1.0) * half,
                                               (1.0 - 2.0 * (y + 0.5) / kSide) * half, -1.0));
      // Intersects the camera ray with the ball of radius 1 at the origin: p = (0, 0, kDistance) +
      // t d.
      const double b = kDistance * d.z;
      const double under = b * b - (kDistance * kDistance - 1.0);
      // Near its outline the ball is visibly a polyhedron, and its reflection changes fast.
      constexpr double kOutline = 0.35;
      if (under > 0.0 && under < kOutline)
        continue;
      if (under > 0.0) {
        const glm::dvec3 normal = glm::dvec3(0, 0, kDistance) + (-b - std::sqrt(under)) * d;
        d = glm::reflect(d, normal);
        ++mirrored;
      } else if (under > -kOutline) {
        continue;
      } else {
        ++background;
      }
      INFO(x << ", " << y << (under > 0.0 ? " in the ball" : ""));
      for (int c = 0; c < 3; ++c)
        CHECK(picture.pixel(x, y)[c] == Approx(0.5 + 0.5 * d[c]).margin(kTolerance));
    }
  CHECK(background > 1000);
  CHECK(mirrored > 100);
}

TEST_CASE("a white metal reflects all the light of lamps in all directions", "[large]") {
  constexpr std::size_t kPictures = 16;
  constexpr std::size_t kLamps = 16; // the maximum
  constexpr std::size_t kDirections = kPictures * kLamps;
  constexpr double kTolerance = 0.03; // for the sum over 256 directions; measured below 2 %
  std::vector<Plate> plates;
  for (const double roughness : {0.5, 0.8, 1.0})
    for (const double view : {0.2, 0.8, 1.2})
      plates.push_back({{std::sin(view), 0.0, std::cos(view)}, 1.0, roughness});
  std::vector<double> albedo(plates.size(), 0.0);
  for (std::size_t picture = 0; picture < kPictures; ++picture) {
    std::vector<glm::dvec3> lamps; // spherical Fibonacci points: each has the same solid angle
    for (std::size_t i = picture; i < kDirections; i += kPictures) {
      const double z = 1.0 - (2.0 * double(i) + 1.0) / double(kDirections);
      const double turn = 2.0 * kPi * double(i) / std::numbers::phi;
      const double r = std::sqrt(1.0 - z * z);
      lamps.push_back({r * std::cos(turn), r * std::sin(turn), z});
    }
    const std::vector<double> measured = radiances(plates, lamps);
    for (std::size_t i = 0; i < plates.size(); ++i)
      albedo[i] += measured[i] * 4.0 * kPi / double(kDirections);
  }
  for (std::size_t i = 0; i < plates.size(); ++i) {
    INFO("roughness " << plates[i].roughness << ", n.v " << plates[i].normal.z);
    CHECK(albedo[i] == Approx(1.0).epsilon(kTolerance));
  }
}

TEST_CASE("a ball occludes its share of the sky, in one frame almost as in many") {
  // Low-discrepancy directions must do better than the same number of random ones.
  constexpr int kSide = 64;
  LinearImage white(2, 1, 3);
  std::fill(white.values.begin(), white.values.end(), 1.0f);
  for (const auto& [frames, directions] : {std::pair(1, 16), {4, 64}, {16, 256}}) {
    RenderSettings settings = settingsUnder(white, kSide);
    settings.frames = std::uint32_t(frames);
    const LinearImage picture = render(ballFromAbove().glb(), settings);
    double squares = 0.0;
    double randomSquares = 0.0;
    int count = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const auto position = [](int i) { return ((i + 0.5) / kSide * 2.0 - 1.0) * kGroundHalf; };
        const double across = std::hypot(position(x), position(y));
        if (across < 1.1) // the ball
          continue;
        const double light = lightBeside(across);
        const double error = double(picture.pixel(x, y)[1]) - light;
        randomSquares += light * (1.0 - light) / directions;
        squares += error * error;
        ++count;
      }
    INFO(frames << " frames");
    REQUIRE(count > 3000);
    CHECK(std::sqrt(squares / count) < std::sqrt(randomSquares / count));
  }
}

TEST_CASE("a white plane under E lux shows E / pi times the exposure, which the scene's strongest "
          "light and the stops set") {
  // [glTF 2.0, appendix B] at normal incidence and roughness 1: diffuse 1 - F, specular F / 4. What
  // is scattered twice adds 0.001.
  constexpr double kFresnel = 0.04;
  constexpr double kReflected = 1.0 - kFresnel + kFresnel / 4.0;
  constexpr double kHeight = 2.0;
  const auto radiance = [&](double lux, double moreLux, double candela, float stops) {
    GltfScene scene;
    addPlate(scene, {kView, 0.0, 1.0}, -0.5f);
    addPlateCamera(scene, 1);
    scene.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", lux}},
        {{"type", "directional"}, {"intensity", moreLux}},
        {{"type", "point"}, {"intensity", candela}}};
    for (int light = 0; light < 3; ++light) // along -z
      addLamp(scene, light, {0.0, 0.5, kHeight});
    RenderSettings settings = settingsUnder(black(), 1);
    settings.exposureEv = stops;
    return double(render(scene.glb(), settings).pixel(0, 0)[1]);
  };
  for (const auto& [lux, stops] : {std::pair{3.0, 0.0f}, {100000.0, 0.0f}, {100000.0, -2.5f}}) {
    const double exposure = 1.05 * kPi / lux * std::exp2(double(stops));
    const double moreLux = 0.25 * lux, candela = 0.5 * lux;
    const double illuminance = lux + moreLux + candela / (kHeight * kHeight);
    INFO(lux << " lux, " << stops << " stops");
    CHECK(radiance(lux, moreLux, candela, stops) ==
          Approx(kReflected * illuminance / kPi * exposure).epsilon(0.005));
  }
}
