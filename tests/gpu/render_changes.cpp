// SPDX-License-Identifier: MIT
// Changes between frames: each picture equals the picture of a file with the same values, rendered
// from scratch.
#include "failure.h"
#include "rendered.h"
#include "scene_renderer.h"
#include "synthetic_noise.h"

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

constexpr std::uint32_t kSide = 48;
constexpr const char* kExtension = "LICHEN_materials_exemplar_noise";

json& useOf(GltfScene& scene) { return scene.json["materials"][0]["extensions"][kExtension]; }

/// A ball with a noise.
GltfScene noisyBall(float distance = 4.0f) {
  const std::array maps{SyntheticMap{3, 64, 64, true, 4}, SyntheticMap{2, 64, 64, false, 4}};
  GltfScene scene(syntheticGlb(maps));
  useOf(scene).update({{"seed", 2}, {"scale", 1.0}});
  scene.addBall(0);
  scene.addCamera(distance, 0.6f);
  scene.addSun(3.0f);
  return scene;
}

/// A renderer that renders a scene repeatedly.
class Session {
public:
  explicit Session(const GltfScene& source)
      : scene_(loaded(source)), renderer_(testDevice(), scene_, settingsOf(kSide, kSide, 1)) {
    testDevice().messages().clear();
  }

  renderer::SceneRenderer& renderer() { return renderer_; }

  std::vector<float> picture() {
    renderer_.drawFrame(0);
    for (const std::string& text : testDevice().messages().texts())
      FAIL_CHECK(text);
    return renderer_.average(1).values;
  }

private:
  renderer::Scene scene_;
  renderer::SceneRenderer renderer_;
};

} // namespace

TEST_CASE("changed noises look as in a file with the same values, and can be changed back") {
  const GltfScene scene = noisyBall();
  Session session(scene);
  const std::vector<float> first = session.picture();
  CHECK(first == render(scene.glb(), settingsOf(kSide, kSide, 1)).values);

  const auto checkAsFile = [&](const renderer::NoiseChanges& changes, const json& use) {
    INFO(use.dump());
    GltfScene changed = scene;
    useOf(changed).update(use);
    session.renderer().setNoise(changes);
    const std::vector<float> picture = session.picture();
    CHECK(picture != first);
    CHECK(picture == render(changed.glb(), settingsOf(kSide, kSide, 1)).values);
  };
  renderer::NoiseChanges changes;
  changes.seedStep = 3;
  changes.scaleFactor = 0.5;
  changes.contrastFactor = 0.5;
  checkAsFile(changes, {{"seed", 5}, {"scale", 0.5}, {"contrast", 0.5}});
  changes = {};
  changes.mapping = renderer::NoiseMapping::triplanar;
  checkAsFile(changes, {{"mapping", "triplanar"}});
  session.renderer().setNoise({});
  CHECK(session.picture() == first);
}

TEST_CASE("changing to texture coordinates that a mesh lacks adds a note") {
  GltfScene scene = noisyBall();
  Session whole(scene);
  CHECK(whole.renderer().notes().empty());
  useOf(scene)["mapping"] = "triplanar";
  for (json& mesh : scene.json["meshes"])
    for (json& primitive : mesh["primitives"])
      primitive["attributes"].erase("TEXCOORD_0");
  Session bare(scene);
  CHECK(bare.renderer().notes().empty());
  renderer::NoiseChanges changes;
  changes.mapping = renderer::NoiseMapping::uv;
  bare.renderer().setNoise(changes);
  const std::vector<std::string> notes = bare.renderer().notes();
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::Contains("/materials/0: its noise is mapped by TEXCOORD_0"));
  bare.renderer().setNoise({});
  CHECK(bare.renderer().notes().empty());
}

TEST_CASE("size, camera, exposure and debug view may change between frames") {
  const GltfScene scene = noisyBall();
  Session session(scene);
  const std::vector<float> first = session.picture();
  renderer::SceneRenderer& renderer = session.renderer();
  const renderer::Camera start = renderer.camera();

  renderer::RenderSettings settings = settingsOf(40, 24, 1);
  settings.debugView = "normals";
  renderer.setSize(40, 24);
  renderer.setDebugView("normals");
  CHECK(session.picture() == render(scene.glb(), settings).values);

  renderer.setSize(kSide, kSide);
  renderer.setDebugView("");
  renderer.setExposure(-1.0f);
  settings = settingsOf(kSide, kSide, 1);
  settings.exposureEv = -1.0f;
  CHECK(session.picture() == render(scene.glb(), settings).values);

  renderer.setExposure(0.0f);
  const GltfScene fromAfar = noisyBall(9.0f);
  renderer.setCamera(Session(fromAfar).renderer().camera());
  const std::vector<float> far = session.picture();
  CHECK(far != first);
  CHECK(far == render(fromAfar.glb(), settingsOf(kSide, kSide, 1)).values);
  renderer.setCamera(start);
  CHECK(session.picture() == first);
}
