// SPDX-License-Identifier: MIT
// Two panes with alpha 1/2, one behind the other: the nearer one covers the farther one, whatever
// their order in the file.
#include "rendered.h"

#include <array>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

constexpr glm::vec3 kNear{1, 0, 0};
constexpr glm::vec3 kFar{0, 1, 0};

std::size_t addGlass(GltfScene& scene, glm::vec3 color, bool doubleSided) {
  return scene.addMaterial(
      {{"alphaMode", "BLEND"},
       {"doubleSided", doubleSided},
       {"pbrMetallicRoughness", {{"baseColorFactor", {color.r, color.g, color.b, 0.5}}}}});
}

/// Adds a square at height z whose front faces up or down.
void addPane(std::vector<std::uint32_t>& indices, std::vector<float>& positions, float z, bool up) {
  const auto first = std::uint32_t(positions.size() / 3);
  positions.insert(positions.end(), {-1, -1, z, 1, -1, z, -1, 1, z, 1, 1, z});
  for (const std::uint32_t i :
       up ? std::array{0u, 1u, 2u, 2u, 1u, 3u} : std::array{0u, 2u, 1u, 1u, 2u, 3u})
    indices.push_back(first + i);
}

void addPaneMesh(GltfScene& scene, std::size_t material, float z) {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  addPane(indices, positions, z, true);
  scene.addMesh({{"POSITION", scene.addFloats(positions, 3)}}, scene.addIndices(indices, 1),
                material);
}

/// The base colour in the centre of a picture from above, at z = 4.
glm::vec3 baseColorInTheMiddle(GltfScene& scene) {
  scene.addCamera(4.0f, 0.3f);
  renderer::RenderSettings settings = settingsOf(8, 8, 1);
  settings.debugView = "base-color";
  const LinearImage picture = render(scene.glb(), settings);
  const float* pixel = &picture.values[3 * (4 * 8 + 4)];
  return {pixel[0], pixel[1], pixel[2]};
}

void checkNearOverFar(glm::vec3 color) {
  const glm::vec3 expected = 0.5f * kNear + 0.25f * kFar; // over black
  for (int c = 0; c < 3; ++c)
    CHECK(color[c] == Approx(expected[c]).margin(1e-3));
}

} // namespace

TEST_CASE("the farther of two panes is drawn first even if their nodes coincide") {
  for (const bool nearFirst : {true, false}) {
    GltfScene scene;
    const std::size_t near = addGlass(scene, kNear, false);
    const std::size_t far = addGlass(scene, kFar, false);
    if (nearFirst)
      addPaneMesh(scene, near, 0.5f);
    addPaneMesh(scene, far, -0.5f);
    if (!nearFirst)
      addPaneMesh(scene, near, 0.5f);
    checkNearOverFar(baseColorInTheMiddle(scene));
  }
}

TEST_CASE("the back of double-sided glass is drawn first") {
  GltfScene scene;
  const std::size_t glass = addGlass(scene, {1, 1, 1}, true);
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  addPane(indices, positions, 0.5f, true);
  addPane(indices, positions, -0.5f, false);
  std::vector<float> colors;
  for (const glm::vec3 color : {kNear, kFar})
    for (int vertex = 0; vertex < 4; ++vertex)
      colors.insert(colors.end(), {color.r, color.g, color.b});
  scene.addMesh(
      {{"POSITION", scene.addFloats(positions, 3)}, {"COLOR_0", scene.addFloats(colors, 3)}},
      scene.addIndices(indices, 1), glass);
  checkNearOverFar(baseColorInTheMiddle(scene));
}
