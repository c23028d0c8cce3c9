// SPDX-License-Identifier: MIT
// Pictures: golden images, the white furnace, and properties that need no golden image.
#include "../unit/bundle_example.h"
#include "golden_picture.h"
#include "picture.h"
#include "rendered.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <tuple>

using namespace lichen;
using namespace lichen::test;
using renderer::RenderSettings;

namespace {

/// Compares with tests/golden/render/NAME.png; with LICHEN_REGENERATE_GOLDEN set, writes it.
void checkGolden(const std::string& name, const LinearImage& picture) {
  const TemporaryFolder folder;
  REQUIRE(renderer::writePicture(folder.path() / "now.png", picture).ok());
  checkGoldenPicture(name, folder.path() / "now.png");
}

/// Three textured balls of different materials on a ground, lit by a sun.
GltfScene stillLife() {
  GltfScene scene;
  const std::size_t checker = scene.addChecker(4, {0.8f, 0.25f, 0.1f}, {0.9f, 0.85f, 0.7f});
  const std::size_t bumps = scene.addChecker(8, {0.65f, 0.5f, 0.95f}, {0.35f, 0.5f, 0.95f});
  const auto matte = scene.addMaterial(
      {{"pbrMetallicRoughness",
        {{"baseColorTexture",
          {{"index", checker}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 1}}}}}}}},
         {"metallicFactor", 0},
         {"roughnessFactor", 0.5}}}});
  const auto metal = scene.addMaterial({{"pbrMetallicRoughness",
                                         {{"baseColorFactor", {0.95, 0.75, 0.4, 1.0}},
                                          {"metallicFactor", 1},
                                          {"roughnessFactor", 0.3}}},
                                        {"normalTexture", {{"index", bumps}, {"scale", 0.5}}}});
  const auto glowing = scene.addMaterial({{"pbrMetallicRoughness",
                                           {{"baseColorFactor", {0.2, 0.5, 0.9, 0.6}},
                                            {"metallicFactor", 0},
                                            {"roughnessFactor", 0.2}}},
                                          {"alphaMode", "BLEND"},
                                          {"emissiveFactor", {0.05, 0.0, 0.1}}});
  const auto ground =
      scene.addMaterial({{"pbrMetallicRoughness",
                          {{"baseColorFactor", {0.4, 0.38, 0.35, 1}}, {"metallicFactor", 0}}}});
  scene.addBall(matte);
  scene.addBall(metal, {{"translation", {-1.7, -0.4, -0.3}}, {"scale", {-0.6, 0.6, 0.6}}});
  scene.addBall(glowing, {{"translation", {1.6, -0.5, 0.6}}, {"scale", {0.5, 0.5, 0.5}}});
  scene.addGround(ground, 40.0f, -1.0f);
  scene.addCamera(6.0f, 0.7f, 1.6f, -0.3f);
  scene.addSun(3.0f);
  return scene;
}

/// Error of a ball of this material in a white furnace, an environment of radiance 1 without other
/// light.
double furnaceError(double metallic, double roughness) {
  GltfScene scene;
  scene.addBall(scene.addMaterial(
      {{"pbrMetallicRoughness", {{"metallicFactor", metallic}, {"roughnessFactor", roughness}}}}));
  scene.addCamera(4.0f, 0.6f);
  RenderSettings settings = settingsOf(48, 48, 1);
  settings.toneMap = false;
  settings.environment = LinearImage(32, 16, 3);
  std::fill(settings.environment->values.begin(), settings.environment->values.end(), 1.0f);
  const LinearImage picture = render(scene.glb(), settings);
  double worst = 0.0;
  for (const float value : picture.values)
    worst = std::max(worst, std::abs(double(value) - 1.0));
  return worst;
}

/// A ball with the first material, with or without a ground of the same material.
std::vector<std::byte> ballOf(const std::vector<std::byte>& bundle, bool withGround) {
  GltfScene scene(bundle);
  scene.addBall(0);
  if (withGround)
    scene.addGround(0, 40.0f, -1.0f);
  scene.addCamera(5.0f, 0.6f, 0.8f, -0.15f);
  scene.addSun(3.0f);
  return scene.glb();
}

/// ballOf() with tiling noise.
std::vector<std::byte> noiseBall(bool withOrm, bool withGround = true) {
  std::vector<SyntheticMap> maps{SyntheticMap{3, 64, 64, true, 4}};
  if (withOrm)
    maps.push_back(SyntheticMap{1, 64, 64, false, 4});
  return ballOf(syntheticGlb(maps), withGround);
}

/// ballOf() with texton noise.
std::vector<std::byte> textonBall(bool withGround = true) {
  SyntheticTexton texton;
  texton.smoothings = 1; // coarse enough for the ball's pixels
  return ballOf(syntheticTextonGlb(texton), withGround);
}

/// ballOf() with triplanar noise.
std::vector<std::byte> triplanarBall(BundleFile file, bool withGround = true) {
  file.bundle.materials[0]->mapping = Mapping::triplanar;
  file.bundle.materials[0]->planeSharpness = 4.0;
  return ballOf(encodeGlb(file).value(), withGround);
}

/// Two boxes with texton noise, without texture coordinates.
std::vector<std::byte> textonBoxes() {
  BundleFile file = syntheticTextonBundle({.smoothings = 1});
  file.bundle.materials[0]->mapping = Mapping::surface;
  GltfScene scene(encodeGlb(file).value());
  for (int box = 0; box < 2; ++box)
    scene.addBox(0, {{"translation", {box == 0 ? -0.9 : 1.1, 0.0, 0.0}},
                     {"rotation", {0.0, std::sin(0.4 + box), 0.0, std::cos(0.4 + box)}}});
  scene.addCamera(5.0f, 0.6f, 0.8f, -0.15f);
  scene.addSun(3.0f);
  return scene.glb();
}

RenderSettings viewOf(std::string_view view) {
  RenderSettings settings = settingsOf(128, 72, 1);
  settings.debugView = view;
  return settings;
}

/// A ball whose noise has what a debug view shows. Without a ground: toward the horizon every pixel
/// is in another triangle, by rounding.
std::vector<std::byte> ballWith(std::string_view view) {
  const SyntheticMap map{3, 64, 64, true, 4};
  if (view == "impacts")
    return textonBall(false);
  if (view == "planes")
    return triplanarBall(syntheticBundle(std::span(&map, 1)), false);
  return noiseBall(false, false);
}

} // namespace

TEST_CASE("pictures of every feature match their golden images") {
  const std::array slopesToo{SyntheticMap{3, 64, 64, true, 4}, SyntheticMap{2, 64, 64, false, 4}};
  BundleFile mix = syntheticTextonBundle({.steps = 5, .smoothings = 1});
  mix.bundle.materials[0]->mix = {
      .source = MixSource::direction, .start = {0.0, 0.0}, .end = {0.0, 1.0}};
  const RenderSettings small = settingsOf(256, 144, 4);
  const std::tuple<const char*, std::vector<std::byte>, RenderSettings> rows[] = {
      {"still_life", stillLife().glb(), settingsOf(256, 160, 8)},
      {"noise_ball", noiseBall(false), small},
      {"noise_orm", noiseBall(true), settingsOf(192, 108, 2)},
      {"texton_ball", textonBall(), small},
      {"texton_surface", textonBoxes(), small},
      {"texton_mix", ballOf(encodeGlb(mix).value(), true), small},
      {"triplanar_tiling", triplanarBall(syntheticBundle(slopesToo)), small},
      {"triplanar_texton", triplanarBall(syntheticTextonBundle({.smoothings = 1})), small}};
  for (const auto& [name, scene, settings] : rows)
    checkGolden(name, render(scene, settings));
  const std::vector<std::byte> ball =
      triplanarBall(syntheticBundle(std::span(slopesToo).first(1)), false);
  for (const char* view : {"weights", "lattice", "mip-level", "gaussian"})
    checkGolden("view_triplanar-" + std::string(view), render(ball, viewOf(view)));
}

TEST_CASE("each debug view of a noise matches its golden image, and no two are alike") {
  std::set<std::vector<float>> seen;
  for (const std::string_view view : renderer::debugViewNames()) {
    const LinearImage picture = render(ballWith(view), viewOf(view));
    checkGolden("view_" + std::string(view), picture);
    CHECK(seen.insert(picture.values).second);
  }
}

TEST_CASE("the views of quilting show its tiles, each in one colour, and the cuts between them") {
  BundleFile file = example::smallestQuilting();
  file.bundle.materials[0]->scale = 0.25;
  const std::vector<std::byte> ball = ballOf(encodeGlb(file).value(), false);
  const LinearImage tiles = render(ball, viewOf("weights")), cuts = render(ball, viewOf("lattice"));
  int pixels = 0, whole = 0;
  std::array<int, 3> of{};
  for (std::size_t i = 0; i < tiles.pixelCount(); ++i) {
    const float* const weights = &tiles.values[3 * i];
    const float sum = weights[0] + weights[1] + weights[2];
    if (std::abs(sum - 1.0f) > 0.01f) // beside the ball, and at its border
      continue;
    ++pixels;
    for (std::size_t c = 0; c < 3; ++c)
      if (weights[c] > 0.95f) {
        ++whole;
        ++of[c];
        // The others have at most a twentieth, and the colour of lines at most 0.08.
        CHECK(cuts.values[3 * i + c] > 0.55f);
      }
  }
  CHECK(pixels > 1000);
  CHECK(whole > pixels / 2);
  for (const int count : of)
    CHECK(count > whole / 10);
}

TEST_CASE("a surface without what a debug view shows is grey") {
  const LinearImage grey = render(noiseBall(false, false), viewOf("impacts"));
  for (int c = 0; c < 3; ++c)
    CHECK(grey.pixel(64, 36)[c] == 0.5f); // in the middle of the ball
}

TEST_CASE("the views of roughness, metallic and occlusion show the values used for shading") {
  GltfScene scene;
  const auto material = scene.addMaterial(
      {{"pbrMetallicRoughness", {{"metallicFactor", 0.75}, {"roughnessFactor", 0.3}}}});
  scene.addBall(material);
  scene.addCamera(4.0f, 0.6f);
  for (const auto& [view, expected] :
       {std::pair{"roughness", 0.3}, std::pair{"metallic", 0.75}, std::pair{"occlusion", 1.0}}) {
    RenderSettings settings = settingsOf(32, 32, 1);
    settings.debugView = view;
    const LinearImage image = render(scene.glb(), settings);
    INFO(view);
    CHECK(double(image.values[3 * (16 * 32 + 16)]) == Approx(expected).margin(1e-3));
  }
}

TEST_CASE("a white ball is invisible in a white furnace at any roughness") {
  // Half floats, and a table of the specular albedo with 32 steps.
  constexpr double kTolerance = 0.01;
  for (const double metallic : {0.0, 1.0})
    for (const double roughness : {0.1, 0.5, 1.0}) {
      INFO("metallic " << metallic << ", roughness " << roughness);
      CHECK(furnaceError(metallic, roughness) < kTolerance);
    }
}

TEST_CASE("exceeding the device's limits is an error, not a crash") {
  const renderer::Scene scene = loaded(triangleScene());
  RenderSettings settings = settingsOf(8, 8, 1);
  settings.width = testDevice().properties().limits.maxImageDimension2D + 1;
  const auto tooWide = renderer::renderScene(testDevice(), scene, settings);
  REQUIRE_FALSE(tooWide.ok());
  CHECK(tooWide.error().kind == ErrorKind::usage);
  settings = settingsOf(8, 8, 1);
  settings.camera = "nowhere";
  CHECK(renderer::renderScene(testDevice(), scene, settings).error().kind == ErrorKind::usage);
}
