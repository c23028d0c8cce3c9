// SPDX-License-Identifier: MIT
// Scenes far from the world's origin look as at the origin, and notes name noise that is too small.
// render_noise_positions.cpp compares noise there with exact arithmetic.
#include "rendered.h"
#include "scene_renderer.h"
#include "synthetic_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

using Position = std::array<double, 3>;

constexpr float kDistance = 3.0f, kFieldOfView = 0.3f; // of a camera in front of a square
constexpr double kLevel = 1.0 / 255.0;

/// Triplanar noise by tiling.
BundleFile tilingBundle() {
  const SyntheticMap map{3, 64, 48};
  BundleFile file = syntheticBundle(std::span(&map, 1));
  MaterialNoise& use = *file.bundle.materials[0];
  use.mapping = Mapping::triplanar;
  use.rotation = 0.4;
  use.scale = 2.0;
  use.seed = 3;
  file.bundle.noises[0].tileSizeMetres = 0.3; // not exactly representable as a float
  return file;
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

TEST_CASE("everything else looks as at the world's origin at any distance") {
  BundleFile file = tilingBundle();
  file.bundle.materials[0]->mapping = Mapping::uv;
  const GltfScene scene = stillLife(file);
  const LinearImage home = render(scene.glb(), stillSettings());
  const LinearImage away =
      render(moved(scene, {1e7 + 0.1, -2e7 + 0.2, 3e7 + 0.3}).glb(), stillSettings());
  CHECK(largestDifference(away, home) < kLevel);
  // Offsets are whole steps of the rendering origin, so nothing is rounded.
  CHECK(render(moved(scene, {1 << 20, -(1 << 17), 1 << 23}).glb(), stillSettings()).values ==
        home.values);
}

TEST_CASE(
    "shaded noise in world space does not depend on the rendering origin, nor on the distance "
    "of an orthographic camera") {
  const renderer::Scene far =
      loaded(moved(stillLife(tilingBundle()), {1e6 + 77.7, 2e6 + 55.5, -1e6 - 33.3}));
  const renderer::Scene near = loaded(moved(stillLife(tilingBundle()), {77.7, 55.5, -33.3}));
  const auto checkAlike = [](const renderer::Scene& scene,
                             const std::vector<renderer::Camera>& cameras) {
    renderer::SceneRenderer sceneRenderer(testDevice(), scene, stillSettings());
    std::vector<LinearImage> pictures;
    for (const renderer::Camera& camera : cameras) {
      sceneRenderer.setCamera(camera);
      sceneRenderer.drawFrame(0);
      pictures.push_back(sceneRenderer.average(1));
      CHECK(largestDifference(pictures.back(), pictures.front()) < 2.0 * kLevel);
    }
  };
  std::vector<renderer::Camera> atOrigins(2, far.cameras[0]), flat;
  atOrigins[1].near = 0.01f;
  CHECK(glm::distance(renderer::originNear(atOrigins[0], {}),
                      renderer::originNear(atOrigins[1], {})) > 10.0);
  checkAlike(far, atOrigins);
  for (const double away : {0.0, 1e5, 1e7}) {
    renderer::Camera camera = near.cameras[0];
    camera.perspective = false;
    camera.halfHeight = 1.5f;
    camera.worldFromCamera[3] += away * camera.worldFromCamera[2];
    camera.near = float(away);
    camera.far = float(away + 20.0);
    flat.push_back(camera);
  }
  checkAlike(near, flat);
}

namespace {

/// A square of the noise in front of a camera.
GltfScene square(const BundleFile& file, const Position& position) {
  GltfScene scene(encodeGlb(file).value());
  scene.addMesh({{"POSITION", scene.addFloats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, 3)}},
                scene.addIndices({0, 1, 2, 0, 2, 3}, 1), 0);
  scene.addCamera(kDistance, kFieldOfView);
  scene.addSun(3.0f);
  return moved(scene, position);
}

} // namespace

TEST_CASE("a note names noise that is too small to be visible") {
  BundleFile file = tilingBundle();
  const auto notesAt = [&](double pixels, float aspectRatio = 0.0f, double aside = 0.0) {
    // in the 48 pixels of stillSettings()
    const double height = 2.0 * kDistance * std::tan(kFieldOfView / 2);
    file.bundle.materials[0]->scale = pixels / 48.0 * height / file.bundle.noises[0].tileSizeMetres;
    renderer::Scene scene = loaded(square(file, {}));
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

TEST_CASE("a note names noise that the lattice cannot resolve") {
  BundleFile file = tilingBundle();
  file.bundle.materials[0]->scale = 1.0 / 16384.0 / 0.3;
  const renderer::Scene scene = loaded(square(file, {0.0, 1e8, 0.0}));
  renderer::SceneRenderer sceneRenderer(testDevice(), scene, stillSettings());
  CHECK(
      sceneRenderer.notes() ==
      std::vector<std::string>{
          "/materials/0: the camera is more than 2^40 tiles of its noise from the world's origin; "
          "the noise there loses detail",
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
