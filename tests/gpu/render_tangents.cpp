// SPDX-License-Identifier: MIT
// A mesh without tangents is drawn as with those that follow from its texture coordinates by hand.
#include "rendered.h"

using namespace lichen;
using namespace lichen::test;

namespace {

/// Texture coordinates over a square of side 2: their derivatives along x and y.
struct Mapped {
  const char* what;
  glm::vec2 u, v;
};

/// The normals of a square that faces the camera, with a texture of one slanted normal.
LinearImage normalsOf(const Mapped& mapped, int texCoord, bool fromBehind, bool hasTangents) {
  GltfScene scene;
  const std::size_t texture = scene.addChecker(1, {0.9f, 0.3f, 0.8f}, {0.9f, 0.3f, 0.8f});
  const std::size_t material = scene.addMaterial(
      {{"doubleSided", true}, {"normalTexture", {{"index", texture}, {"texCoord", texCoord}}}});
  std::vector<float> positions, normals, coordinates, tangents;
  const glm::vec2 alongU = glm::inverse(glm::transpose(glm::mat2(mapped.u, mapped.v)))[0];
  const glm::vec2 alongV = glm::inverse(glm::transpose(glm::mat2(mapped.u, mapped.v)))[1];
  const glm::vec2 t = glm::normalize(alongU);
  const float side = t.x * alongV.y - t.y * alongV.x < 0.0f ? 1.0f : -1.0f; // toward lesser v
  for (const glm::vec2 p : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    positions.insert(positions.end(), {p.x, p.y, 0.0f});
    normals.insert(normals.end(), {0.0f, 0.0f, fromBehind ? -1.0f : 1.0f});
    coordinates.insert(coordinates.end(), {glm::dot(mapped.u, p), glm::dot(mapped.v, p)});
    tangents.insert(tangents.end(), {t.x, t.y, 0.0f, fromBehind ? -side : side});
  }
  nlohmann::json attributes{{"POSITION", scene.addFloats(positions, 3)},
                            {"NORMAL", scene.addFloats(normals, 3)}};
  attributes["TEXCOORD_0"] =
      scene.addFloats(texCoord == 0 ? coordinates : std::vector<float>(8, 0.5f), 2);
  attributes["TEXCOORD_1"] = scene.addFloats(coordinates, 2);
  if (hasTangents)
    attributes["TANGENT"] = scene.addFloats(tangents, 4);
  const std::vector<std::uint32_t> front{0, 1, 2, 0, 2, 3}, back{0, 2, 1, 0, 3, 2};
  scene.addMesh(attributes, scene.addIndices(fromBehind ? back : front, 1), material);
  scene.addCamera(4.0f, 0.4f);
  renderer::RenderSettings settings = settingsOf(8, 8, 1);
  settings.debugView = "normals";
  return render(scene.glb(), settings);
}

} // namespace

TEST_CASE("without tangents in the file, normals follow the derivatives of the texture") {
  const Mapped kMapped[] = {{"upright", {0.5f, 0.0f}, {0.0f, -0.5f}},
                            {"mirrored", {-0.5f, 0.0f}, {0.0f, -0.5f}},
                            {"turned", {0.0f, 1.5f}, {0.5f, 0.0f}},
                            {"sheared", {1.0f, 0.5f}, {0.25f, -1.0f}}};
  for (const Mapped& mapped : kMapped)
    for (const int texCoord : {0, 1})
      for (const bool fromBehind : {false, true}) {
        INFO(mapped.what << ", texture coordinates " << texCoord << ", from behind " << fromBehind);
        const LinearImage expected = normalsOf(mapped, texCoord, fromBehind, true);
        const LinearImage drawn = normalsOf(mapped, texCoord, fromBehind, false);
        CHECK(std::abs(expected.values[0] - 0.5f) + std::abs(expected.values[1] - 0.5f) > 0.1f);
        for (std::size_t i = 0; i < drawn.values.size(); ++i)
          REQUIRE(drawn.values[i] == Approx(expected.values[i]).margin(2e-3));
      }
}
