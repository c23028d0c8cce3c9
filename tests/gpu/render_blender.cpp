// SPDX-License-Identifier: MIT
// Compares scenes exported by Blender with what Blender itself sees through the same cameras:
// positions of object corners in the picture, and the material of each pixel.
// tests/scenes/blender/export_scenes.py wrote both and documents framing.json.
#include "checkout_paths.h"
#include "framing.h"
#include "rendered.h"

#include <fstream>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;
using renderer::Scene;

namespace {

const std::filesystem::path kFolder = sourcePath("tests/scenes/blender");
constexpr std::uintmax_t kMostBytes = 1'000'000;
const std::array kNames{"terrain", "monkeys", "interior"};

json framing(const std::string& name) {
  std::ifstream file(kFolder / "framing.json");
  return json::parse(file).at(name);
}

Scene sceneOf(const std::string& name) {
  auto scene = renderer::readScene(kFolder / (name + ".glb"));
  if (!scene)
    FAIL(scene.error().message);
  return std::move(scene).value();
}

/// A unique colour per material from the bits of its index plus 1; black means no material.
glm::vec3 codeColor(int index) {
  const int code = index + 1;
  return {float(code & 1), float(code >> 1 & 1), float(code >> 2 & 1)};
}

/// Replaces each material by its unique colour.
void paint(Scene& scene, const json& names) {
  for (renderer::Primitive& primitive : scene.primitives)
    for (renderer::Vertex& vertex : primitive.vertices)
      vertex.color = glm::vec4(1.0f);
  for (renderer::Material& material : scene.materials) {
    int index = -1;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == material.name)
        index = int(i);
    material = renderer::Material();
    material.baseColor = glm::vec4(codeColor(index), 1.0f);
    material.doubleSided = true;
  }
}

/// Material index of each pixel, decoded from the run lengths in framing.json.
std::vector<int> visibleMaterials(const json& view) {
  std::vector<int> visible;
  const json& runs = view.at("runs");
  for (std::size_t i = 0; i < runs.size(); i += 2)
    visible.insert(visible.end(), runs[i + 1].get<std::size_t>(), runs[i].get<int>());
  return visible;
}

} // namespace

TEST_CASE("Blender's exports are small and load without notes") {
  for (const std::string name : kNames) {
    INFO(name);
    CHECK(std::filesystem::file_size(kFolder / (name + ".glb")) < kMostBytes);
    CHECK(sceneOf(name).notes.empty());
  }
}

TEST_CASE("a camera from Blender projects corners of objects like Blender") {
  // Relative to the picture's side, with pixels of 1/320 or less: 1e-6 m of rounding at a distance
  // of one metre, and float matrices.
  constexpr double kTolerance = 1e-5;
  std::size_t points = 0;
  for (const std::string name : kNames) {
    const Scene scene = sceneOf(name);
    const auto subject = renderer::subjectOf(scene);
    REQUIRE(subject.ok());
    const json views = framing(name);
    for (const auto& [cameraName, view] : views.items()) {
      INFO(name << ", " << cameraName);
      const float aspect = view["size"][0].get<float>() / view["size"][1].get<float>();
      const auto camera = renderer::chooseCamera(scene, subject.value(), cameraName, aspect);
      REQUIRE(camera.ok());
      const glm::mat4 clip = renderer::clipFromWorld(camera.value(), {}, aspect, glm::vec2(0.0f));
      for (const json& point : view["points"]) {
        const auto world = point[0].get<std::array<float, 3>>();
        const glm::vec4 p = clip * glm::vec4(world[0], world[1], world[2], 1.0f);
        CHECK(0.5 + 0.5 * p.x / p.w == Approx(point[1][0].get<double>()).margin(kTolerance));
        CHECK(0.5 + 0.5 * p.y / p.w == Approx(point[1][1].get<double>()).margin(kTolerance));
        ++points;
      }
    }
  }
  CHECK(points > 50);
}

TEST_CASE("each pixel shows the material that Blender's ray hits first") {
  // Rays and rasterization round differently if an edge passes through a pixel's centre.
  constexpr double kMostWrong = 0.0002;
  for (const std::string name : kNames) {
    const json views = framing(name);
    for (const auto& [cameraName, view] : views.items()) {
      INFO(name << ", " << cameraName);
      Scene scene = sceneOf(name);
      paint(scene, view["materials"]);
      renderer::RenderSettings settings =
          settingsOf(view["size"][0].get<std::uint32_t>(), view["size"][1].get<std::uint32_t>(), 1);
      settings.camera = cameraName;
      settings.debugView = "base-color";
      const auto picture = renderer::renderScene(testDevice(), scene, settings);
      REQUIRE(picture.ok());
      const std::vector<int> visible = visibleMaterials(view);
      const LinearImage& pixels = picture.value().pixels;
      REQUIRE(visible.size() == pixels.pixelCount());
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < visible.size(); ++i) {
        const float* p = &pixels.values[3 * i];
        wrong += glm::distance(glm::vec3(p[0], p[1], p[2]), codeColor(visible[i])) > 0.1f;
      }
      INFO(wrong << " pixels of " << visible.size());
      CHECK(double(wrong) <= kMostWrong * double(visible.size()));
    }
  }
}
