// SPDX-License-Identifier: MIT
// Scenes far from the world's origin: noise has the pattern that exact arithmetic gives for a
// position, and everything else looks as at the origin.
#include "rendered.h"
#include "scene_renderer.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/noise_evaluator.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

using Position = std::array<double, 3>;

constexpr int kWidth = 24, kHeight = 16;
constexpr float kDistance = 3.0f, kFieldOfView = 0.3f;
constexpr float kLevel = 1.0f / 255.0f;
constexpr std::array<float, 3> kNormal{6.0f / 11.0f, 6.0f / 11.0f,
                                       7.0f / 11.0f}; // all planes contribute
constexpr std::array<float, 4> kTangent{7.0f / 11.0f, -6.0f / 11.0f, 6.0f / 11.0f, 1.0f};

const std::array<Position, 5> kPositions{{{0, 0, 0},
                                          {12.3, -45.6, 7.8},
                                          {1e5 + 0.3, 2e5 - 0.7, -3e5 + 0.1},
                                          {-1234567.8, 1e6, 7654.3},
                                          {1e7 + 0.1, -2e7 + 0.2, 3e7 + 0.3}}};

BundleFile tilingBundle() {
  const SyntheticMap map{3, 64, 48};
  return syntheticBundle(std::span(&map, 1));
}

void setParameters(BundleFile& file, Mapping mapping) {
  MaterialNoise& use = *file.bundle.materials[0];
  use.mapping = mapping;
  use.rotation = 0.4;
  use.scale = 2.0;
  use.seed = 3;
  file.bundle.noises[0].tileSizeMetres = 0.3; // not exactly representable as a float
}

/// A square at each position, with a camera that faces it and sees nothing else.
GltfScene squares(const BundleFile& file, std::span<const Position> centers) {
  GltfScene scene(encodeGlb(file).value());
  std::vector<float> normals, tangents;
  for (int corner = 0; corner < 4; ++corner) {
    normals.insert(normals.end(), kNormal.begin(), kNormal.end());
    tangents.insert(tangents.end(), kTangent.begin(), kTangent.end());
  }
  const std::size_t positions = scene.addFloats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, 3);
  const std::size_t along = scene.addFloats(normals, 3);
  const json attributes{
      {"POSITION", positions}, {"NORMAL", along}, {"TANGENT", scene.addFloats(tangents, 4)}};
  scene.addMesh(attributes, scene.addIndices({0, 1, 2, 0, 2, 3}, 1), 0);
  scene.addCamera(kDistance, kFieldOfView);
  json& nodes = scene.json["nodes"];
  const json square = nodes[0], camera = nodes[1];
  nodes = json::array();
  json roots = json::array();
  for (const Position& position : centers) {
    const std::size_t first = nodes.size();
    nodes.push_back(square);
    nodes.push_back(camera);
    nodes.push_back({{"translation", position}, {"children", {first, first + 1}}});
    roots.push_back(first + 2);
  }
  scene.json["scenes"][0]["nodes"] = roots;
  scene.addSun(3.0f); // same sun as in the other scenes, so that the cached sky is reused
  return scene;
}

renderer::Scene read(const GltfScene& source) {
  const TemporaryFolder folder;
  auto scene = renderer::readScene(writeInto(folder, "scene.glb", source.glb()));
  if (!scene)
    FAIL(scene.error().message);
  return std::move(scene).value();
}

/// The squares' base colours, rendered by one camera that moves between them.
class Flight {
public:
  explicit Flight(const BundleFile& file)
      : scene_(read(squares(file, kPositions))), renderer_(testDevice(), scene_, settings()) {
    testDevice().messages().clear();
  }

  renderer::SceneRenderer& renderer() { return renderer_; }

  LinearImage pictureAt(std::size_t position) {
    renderer_.setCamera(scene_.cameras.at(position));
    renderer_.drawFrame(0);
    for (const std::string& text : testDevice().messages().texts())
      FAIL_CHECK(text);
    return renderer_.average(1);
  }

private:
  static renderer::RenderSettings settings() {
    renderer::RenderSettings settings = settingsOf(kWidth, kHeight, 1);
    settings.debugView = "base-color";
    return settings;
  }

  renderer::Scene scene_;
  renderer::SceneRenderer renderer_;
};

/// A world position as a whole number of tiles and a remainder.
struct Tiles {
  Tiles(const BundleFile& file, const Position& position) {
    const double side = file.bundle.materials[0]->scale * file.bundle.noises[0].tileSizeMetres;
    std::array<std::int64_t, 3> whole{};
    for (std::size_t k = 0; k < 3; ++k) {
      whole[k] = std::int64_t(std::floor(position[k] / side));
      rest[k] = float(position[k] - side * double(whole[k]));
    }
    origin.tileOriginX = whole[0];
    origin.tileOriginY = whole[1];
    origin.tileOriginZ = whole[2];
  }
  Placement origin;
  std::array<float, 3> rest{};
};

/// The footprint of a pixel on its square.
template <class Footprint>
Footprint footprint(const std::array<float, 3>& rest, int x, int y) {
  const float pixel = 2.0f * kDistance * std::tan(kFieldOfView / 2) / kHeight;
  Footprint at;
  at.position = {rest[0] + (float(x) + 0.5f - kWidth / 2) * pixel,
                 rest[1] + (kHeight / 2 - float(y) - 0.5f) * pixel, rest[2]};
  at.dx = {pixel, 0.0f, 0.0f};
  at.dy = {0.0f, -pixel, 0.0f};
  at.normal = kNormal;
  if constexpr (requires { at.tangent; })
    at.tangent = kTangent;
  return at;
}

/// The mean difference of a picture from `expected(x, y)`.
template <class Expected>
double meanDifference(const LinearImage& picture, const Expected& expected) {
  double sum = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        sum += std::abs(double(picture.pixel(x, y)[c]) - double(expected(x, y)[c]));
  return sum / (3 * kWidth * kHeight);
}

float greatestDifference(const LinearImage& a, const LinearImage& b) {
  float greatest = 0.0f;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    greatest = std::max(greatest, std::abs(a.values[i] - b.values[i]));
  return greatest;
}

/// Compares each pixel of each square with the noise in C++.
template <class Footprint>
void checkPattern(const BundleFile& file, Flight& flight) {
  const auto valuesOf = [&](const Tiles& tiles) {
    auto noise = NoiseEvaluator::create(file.bundle, *file.bundle.materials[0], tiles.origin);
    return [noise = std::move(noise).value(), rest = tiles.rest](int x, int y) {
      return noise->evaluate(0, footprint<Footprint>(rest, x, y));
    };
  };
  for (std::size_t i = 0; i < kPositions.size(); ++i) {
    const LinearImage picture = flight.pictureAt(i);
    const auto expectedAt = valuesOf(Tiles(file, kPositions[i]));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const auto expected = expectedAt(x, y);
        INFO("position " << i << ", pixel " << x << ", " << y);
        for (std::size_t c = 0; c < 3; ++c)
          REQUIRE(picture.pixel(x, y)[c] == Approx(expected[c]).margin(kLevel));
      }
  }
  // The pattern differs from those one tile and half a tile away.
  const LinearImage picture = flight.pictureAt(kPositions.size() - 1);
  Tiles next(file, kPositions.back()), half = next;
  next.origin.tileOriginX += 1;
  half.rest[1] += 0.3f;
  for (const Tiles& other : {next, half})
    CHECK(meanDifference(picture, valuesOf(other)) > 2.0 * double(kLevel));
}

/// The scene with all its nodes moved.
GltfScene moved(GltfScene scene, const Position& offset) {
  json& roots = scene.json["scenes"][0]["nodes"];
  scene.json["nodes"].push_back({{"translation", offset}, {"children", roots}});
  roots = {scene.json["nodes"].size() - 1};
  return scene;
}

/// A ball and a blended box on a ground, lit by a sun that casts shadows and by a lamp.
GltfScene stillLife(const BundleFile& file) {
  GltfScene scene(encodeGlb(file).value());
  const json glass{{"alphaMode", "BLEND"},
                   {"pbrMetallicRoughness", {{"baseColorFactor", {0.2, 0.5, 0.9, 0.6}}}}};
  scene.addBall(0, {{"translation", {-0.5, 0.0, 0.2}}});
  scene.addBox(scene.addMaterial(glass), {{"translation", {0.9, -0.2, -0.6}}});
  scene.addGround(0, 8.0f, -1.0f);
  scene.addCamera(5.0f, 0.7f, 1.2f, -0.25f);
  scene.addSun(3.0f);
  scene.json["extensions"]["KHR_lights_punctual"]["lights"].push_back(
      {{"type", "spot"}, {"spot", json::object()}, {"intensity", 6}, {"color", {1.0, 0.5, 0.2}}});
  scene.json["nodes"].push_back({{"translation", {0.5, 0.3, 2.0}},
                                 {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  scene.json["scenes"][0]["nodes"].push_back(scene.json["nodes"].size() - 1);
  return scene;
}

renderer::RenderSettings stillSettings() { return settingsOf(64, 48, 1); }

} // namespace

TEST_CASE("triplanar noise has the pattern of its world position at any distance") {
  BundleFile file = tilingBundle();
  setParameters(file, Mapping::triplanar);
  Flight flight(file);
  checkPattern<TriplanarFootprint>(file, flight);
  CHECK(flight.renderer().notes().empty());
  // In object space, all squares have the same pattern.
  flight.renderer().setNoise({.inObjectSpace = true});
  const LinearImage home = flight.pictureAt(0);
  for (std::size_t i = 1; i < kPositions.size(); ++i)
    CHECK(greatestDifference(flight.pictureAt(i), home) < kLevel);
}

TEST_CASE("noise on a surface has the pattern of its world position at any distance") {
  BundleFile file = syntheticTextonBundle({.wholeFloats = true});
  setParameters(file, Mapping::surface);
  Flight flight(file);
  checkPattern<SurfaceFootprint>(file, flight);
}

TEST_CASE("everything else looks as at the world's origin at any distance") {
  const GltfScene scene = stillLife(tilingBundle());
  const LinearImage home = render(scene.glb(), stillSettings());
  const LinearImage away = render(moved(scene, kPositions.back()).glb(), stillSettings());
  CHECK(greatestDifference(away, home) < kLevel);
  // Offsets are whole steps of the rendering origin, so nothing is rounded.
  CHECK(render(moved(scene, {1 << 20, -(1 << 17), 1 << 23}).glb(), stillSettings()).values ==
        home.values);
}

TEST_CASE("shaded noise in world space does not depend on the rendering origin") {
  BundleFile file = tilingBundle();
  setParameters(file, Mapping::triplanar);
  const renderer::Scene scene = read(moved(stillLife(file), {1e6 + 77.7, 2e6 + 55.5, -1e6 - 33.3}));
  renderer::SceneRenderer sceneRenderer(testDevice(), scene, stillSettings());
  std::vector<LinearImage> pictures;
  std::vector<glm::dvec3> origins;
  for (const float near : {0.1f, 0.01f}) {
    renderer::Camera camera = scene.cameras[0];
    camera.near = near;
    sceneRenderer.setCamera(camera);
    sceneRenderer.drawFrame(0);
    pictures.push_back(sceneRenderer.average(1));
    origins.push_back(renderer::originNear(camera, {}));
  }
  CHECK(glm::distance(origins[0], origins[1]) > 10.0);
  CHECK(greatestDifference(pictures[0], pictures[1]) < 2.0f * kLevel);
}

TEST_CASE("an orthographic camera is as precise from far away as from nearby") {
  BundleFile file = tilingBundle();
  setParameters(file, Mapping::triplanar);
  const renderer::Scene scene = read(moved(stillLife(file), {77.7, 55.5, -33.3}));
  renderer::SceneRenderer sceneRenderer(testDevice(), scene, stillSettings());
  std::vector<LinearImage> pictures;
  for (const double away : {0.0, 1e5, 1e7}) {
    renderer::Camera camera = scene.cameras[0];
    camera.perspective = false;
    camera.halfHeight = 1.5f;
    camera.worldFromCamera[3] += away * camera.worldFromCamera[2];
    camera.near = float(away);
    camera.far = float(away + 20.0);
    sceneRenderer.setCamera(camera);
    sceneRenderer.drawFrame(0);
    pictures.push_back(sceneRenderer.average(1));
  }
  for (std::size_t i = 1; i < pictures.size(); ++i)
    CHECK(greatestDifference(pictures[i], pictures[0]) < 2.0f * kLevel);
}

TEST_CASE("a note names noise that is too small to be visible") {
  BundleFile file = tilingBundle();
  setParameters(file, Mapping::triplanar);
  const Position position{0.0, 0.0, 0.0};
  const auto notesAt = [&](double pixels, float aspectRatio = 0.0f, double aside = 0.0) {
    // in the 48 pixels of stillSettings()
    const double height = 2.0 * kDistance * std::tan(kFieldOfView / 2);
    file.bundle.materials[0]->scale = pixels / 48.0 * height / file.bundle.noises[0].tileSizeMetres;
    renderer::Scene scene = read(squares(file, {&position, 1}));
    scene.cameras[0].aspectRatio = aspectRatio;
    scene.cameras[0].worldFromCamera[3].x += aside;
    return renderer::SceneRenderer(testDevice(), scene, stillSettings()).notes();
  };
  const std::vector<std::string> expectedNotes{
      "/materials/0: an exemplar of its noise is at most 3.2 pixels wide, so little more than "
      "the mean is visible; use a larger scale or move the camera closer"};
  CHECK(notesAt(4.1).empty());
  CHECK(notesAt(3.2) == expectedNotes);
  // A camera three times as wide as the picture shows more above and below.
  CHECK(notesAt(9.6, 4.0f) == expectedNotes);
  // Size on screen does not depend on the distance to the viewing axis.
  CHECK(notesAt(3.2, 0.0f, 9.0) == expectedNotes);
  CHECK(notesAt(4.1, 0.0f, 9.0).empty());
}

TEST_CASE("a note names noise that floats or the lattice cannot resolve") {
  BundleFile file = tilingBundle();
  setParameters(file, Mapping::triplanar);
  file.bundle.materials[0]->scale = 1.0 / 16384.0 / 0.3; // corners are sqrt(2) from their node
  const Position position{0.0, 1e8, 0.0};
  const renderer::Scene scene = read(squares(file, {&position, 1}));
  renderer::RenderSettings settings = stillSettings();
  settings.debugView = "planes";
  renderer::SceneRenderer sceneRenderer(testDevice(), scene, settings);
  CHECK(
      sceneRenderer.notes() ==
      std::vector<std::string>{
          "/materials/0: the camera is more than 2^40 tiles of its noise from the world's origin; "
          "the noise there loses detail",
          "/materials/0: vertices are 1.41 units from their node's origin, where floats are "
          "1.2e-07 apart; its noise, with tiles of 6.1e-05, may lose detail there; move the "
          "node's origin closer to its vertices",
          "/materials/0: an exemplar of its noise is at most 0.0032 pixels wide, so little more "
          "than the mean is visible; use a larger scale or move the camera closer"});
  renderer::Camera home = scene.cameras[0];
  home.worldFromCamera[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
  sceneRenderer.setCamera(home);
  const std::vector<std::string> notes = sceneRenderer.notes();
  CHECK(std::none_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("the camera is") != note.npos;
  }));
}
