// SPDX-License-Identifier: MIT
// Displaced surfaces: their outlines against points that the noise displaces in C++, and which
// surfaces are displaced. render_refinement.cpp has the distance of vertices, and cracks.
#include "../unit/bundle_example.h"
#include "rendered.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/noise_evaluator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kSide = 192;                             // of the picture, in pixels
constexpr float kDistance = 5.0f, kFieldOfView = 0.6f; // of the camera
constexpr int kRings = 32, kSegments = 64;             // of GltfScene::addBall()
constexpr double kPi = std::numbers::pi;
constexpr float kDepth = 0.4f;

using Point = glm::dvec3;

/// A corner of the ball: its position is its normal. Texture coordinates are 0 to 2 and 0 to 1.
struct Corner {
  Point position;
  std::array<double, 2> uv{};
};

Corner cornerAt(int ring, int segment) {
  const double polar = kPi * ring / kRings, azimuth = 2.0 * kPi * (segment % kSegments) / kSegments;
  return {
      {std::sin(polar) * std::cos(azimuth), std::cos(polar), -std::sin(polar) * std::sin(azimuth)},
      {2.0 * segment / kSegments, double(ring) / kRings}};
}

/// From the ball's space to the world: y becomes z.
Point inWorld(const Point& p) { return {p.x, -p.z, p.y}; }

/// Its axis points at the camera, so that the outline has neither its poles nor, but for one point,
/// its border of texture coordinates.
std::vector<std::byte> ballScene(const BundleFile& file) {
  GltfScene scene(encodeGlb(file).value());
  const double half = std::sqrt(0.5);
  scene.addBall(0, {{"rotation", {half, 0.0, 0.0, half}}});
  scene.addCamera(kDistance, kFieldOfView);
  return scene.glb();
}

renderer::RenderSettings displaced(float depth) {
  renderer::RenderSettings settings = settingsOf(kSide, kSide, 1);
  settings.debugView = "roughness"; // no pixel of the ball is black
  settings.displacement = {depth, renderer::kVertexSpacing};
  return settings;
}

bool isCovered(const LinearImage& picture, int x, int y) {
  return x >= 0 && y >= 0 && x < picture.width && y < picture.height &&
         picture.pixel(x, y)[0] > 0.0f;
}

/// Radii of an outline around the middle of the picture, in pixels, by angle.
constexpr int kAngles = 360;
using Outline = std::array<double, kAngles>;

Outline outlineOf(const LinearImage& picture) {
  Outline radii{};
  for (int k = 0; k < kAngles; ++k) {
    const double angle = 2.0 * kPi * (k + 0.5) / kAngles;
    double radius = kSide / 2.0;
    const auto covered = [&] {
      return isCovered(picture, int(std::floor(kSide / 2.0 + radius * std::cos(angle))),
                       int(std::floor(kSide / 2.0 - radius * std::sin(angle))));
    };
    constexpr double kStep = 0.05;
    while (radius > 0.0 && !covered())
      radius -= kStep;
    radii[std::size_t(k)] = radius;
  }
  return radii;
}

/// The outline of densely sampled points of the mesh, each displaced by the CPU's noise. Not where
/// the border of texture coordinates is: there, and wherever no point is, radii are 0.
Outline expectedOutline(const NoiseEvaluator& noise, double depth) {
  constexpr int kFine = 18;            // points along an edge, half a pixel apart
  constexpr double kLeastAcross = 0.8; // of a normal of the outline, across the view
  const double pixels = kSide / 2.0 / std::tan(double(kFieldOfView) / 2.0);
  Outline radii{};
  const auto add = [&](const std::array<Corner, 3>& corner, double a, double b) {
    const double c = 1.0 - a - b;
    const Point on = a * corner[0].position + b * corner[1].position + c * corner[2].position;
    const std::array<double, 2> uv{a * corner[0].uv[0] + b * corner[1].uv[0] + c * corner[2].uv[0],
                                   a * corner[0].uv[1] + b * corner[1].uv[1] + c * corner[2].uv[1]};
    // Smaller than a texel, so nothing is filtered.
    const UvFootprint at{{float(uv[0]), float(uv[1])}, {1e-4f, 0.0f}, {0.0f, 1e-4f}};
    const double height = std::clamp(double(noise.evaluateUv(0, at)[0]), 0.0, 1.0);
    const Point moved = inWorld(on + (depth * height / glm::length(on)) * on);
    const double scale = pixels / (double(kDistance) - moved.z);
    double angle = std::atan2(moved.y, moved.x) / (2.0 * kPi);
    angle -= std::floor(angle);
    double& radius = radii[std::size_t(std::min(int(angle * kAngles), kAngles - 1))];
    radius = std::max(radius, scale * std::hypot(moved.x, moved.y));
  };
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSegments; ++j) {
      const Corner low = cornerAt(i, j), high = cornerAt(i + 1, j);
      const Corner lowNext = cornerAt(i, j + 1), highNext = cornerAt(i + 1, j + 1);
      if (std::hypot(low.position.x, low.position.z) < kLeastAcross || j == 0 || j == kSegments - 1)
        continue;
      for (int p = 0; p <= kFine; ++p)
        for (int q = 0; p + q <= kFine; ++q) {
          add({low, high, lowNext}, double(p) / kFine, double(q) / kFine);
          add({lowNext, high, highNext}, double(p) / kFine, double(q) / kFine);
        }
    }
  return radii;
}

struct Difference {
  double mean = 0.0, most = 0.0; ///< pixels
};

/// The difference of the radii that both have.
Difference difference(const Outline& a, const Outline& b) {
  Difference result;
  int count = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] > 0.0 && b[k] > 0.0) {
      const double between = std::abs(a[k] - b[k]);
      result.mean += between;
      result.most = std::max(result.most, between);
      ++count;
    }
  REQUIRE(count > kAngles * 9 / 10);
  result.mean /= count;
  return result;
}

/// A height map of each method, whose details are several pixels wide on the ball.
std::array<BundleFile, 3> heightMaps() {
  const SyntheticMap tiling{
      .dimensions = 1, .width = 16, .height = 16, .table = SyntheticTable::none};
  std::array<BundleFile, 3> files{syntheticBundle(std::span(&tiling, 1)),
                                  syntheticTextonBundle({.texelsPerTileX = 32,
                                                         .texelsPerTileY = 24,
                                                         .channels = 1,
                                                         .smoothings = 2,
                                                         .deviation = 0.15}),
                                  example::smallestCosines()};
  for (BundleFile& file : files)
    file.bundle.materials[0]->scale = 1.0;
  return files;
}

} // namespace

TEST_CASE("a displaced ball has the outline of points displaced on the CPU, by each method") {
  for (const BundleFile& file : heightMaps()) {
    INFO(file.bundle.noises[0].name);
    const auto noise = NoiseEvaluator::create(file.bundle, *file.bundle.materials[0]).value();
    const Outline expected = expectedOutline(*noise, double(kDepth));
    const std::vector<std::byte> scene = ballScene(file);
    const Difference error = difference(outlineOf(render(scene, displaced(kDepth))), expected);
    INFO("mean " << error.mean << ", most " << error.most);
    CHECK(error.mean < 0.5);
    CHECK(error.most < 3.0);
    // The relief is much larger than those errors.
    const Outline flat = expectedOutline(*noise, 0.0);
    double least = kSide, most = 0.0;
    for (std::size_t k = 0; k < kAngles; ++k)
      if (expected[k] > 0.0) {
        least = std::min(least, expected[k] - flat[k]);
        most = std::max(most, expected[k] - flat[k]);
      }
    CHECK(most - least > 6.0);
  }
}

TEST_CASE("triplanar and surface mapping displace in world and object space") {
  BundleFile file = heightMaps()[1];
  MaterialNoise& use = *file.bundle.materials[0];
  for (const Mapping mapping : {Mapping::triplanar, Mapping::surface})
    for (const NoiseSpace space : {NoiseSpace::world, NoiseSpace::object}) {
      use.mapping = mapping;
      use.space = space;
      INFO(nameOf(mapping) << ", " << nameOf(space));
      const std::vector<std::byte> scene = ballScene(file);
      const Outline drawn = outlineOf(render(scene, displaced(kDepth)));
      CHECK(*std::max_element(drawn.begin(), drawn.end()) -
                *std::min_element(drawn.begin(), drawn.end()) >
            6.0);
    }
}

TEST_CASE(
    "a scene without a height map is not displaced but refused, and one whose height map is not "
    "shown is noted") {
  const SyntheticMap colors{3, 16, 16};
  const TemporaryFolder folder;
  const auto path =
      writeInto(folder, "scene.glb", ballScene(syntheticBundle(std::span(&colors, 1))));
  const auto scene = renderer::readScene(path);
  REQUIRE(scene.ok());
  const auto picture = renderer::renderScene(testDevice(), scene.value(), displaced(kDepth));
  REQUIRE_FALSE(picture.ok());
  CHECK(picture.error().kind == ErrorKind::badInput);
  CHECK(picture.error().message.find(path.string()) == 0);
  CHECK(picture.error().message.find("height map") != std::string::npos);
  for (const float depth : {0.0f, kDepth}) {
    std::string notes;
    for (const std::string& note :
         renderPicture(ballScene(heightMaps()[0]), displaced(depth)).notes)
      notes += note;
    CHECK((notes.find("--displace") != std::string::npos) == (depth == 0.0f));
  }
}
