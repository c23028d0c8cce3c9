// SPDX-License-Identifier: MIT
// Skins and morph targets have the pose of the file's nodes and weights; the expected corners are
// computed by hand.
#include "loaded_scene.h"

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;
using renderer::Scene;

namespace {

/// Corners of the first triangle of an instance, in the world.
std::array<glm::vec3, 3> corners(const Scene& scene, std::size_t instance = 0) {
  const renderer::Instance& placed = scene.instances.at(instance);
  const renderer::Primitive& primitive = scene.primitives[placed.primitive];
  std::array<glm::vec3, 3> result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = glm::vec3(placed.worldFromObject *
                          glm::dvec4(primitive.vertices[primitive.indices[k]].position, 1.0));
  return result;
}

void checkNear(glm::vec3 found, glm::vec3 expected) {
  for (int c = 0; c < 3; ++c)
    CHECK(found[c] == Approx(expected[c]).margin(1e-5));
}

std::size_t addAccessor(GltfScene& scene, std::span<const std::byte> bytes, int component,
                        const char* type, std::size_t count) {
  scene.json["accessors"].push_back({{"bufferView", scene.addView(bytes)},
                                     {"componentType", component},
                                     {"type", type},
                                     {"count", count}});
  return scene.json["accessors"].size() - 1;
}

json& attributesOf(GltfScene& scene) {
  return scene.json["meshes"][0]["primitives"][0]["attributes"];
}

/// The triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), whose corners follow joint 0, joint 1, and both
/// equally. Its own node is far away. Matrices have 16 floats each.
GltfScene skinnedTriangle(json joint0, json joint1, const std::vector<float>& inverseBind) {
  GltfScene scene = triangleScene();
  scene.json["nodes"][0]["translation"] = {100, 200, 300};
  scene.json["nodes"][0]["skin"] = 0;
  scene.json["nodes"].push_back(std::move(joint0));
  scene.json["nodes"].push_back(std::move(joint1));
  scene.json["scenes"][0]["nodes"] = {0, 1, 2};
  // joint 9 has no weight
  const std::vector<std::uint8_t> joints{0, 9, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
  const std::vector<std::uint16_t> weights{65535, 0, 0, 0, 65535, 0, 0, 0, 65535, 65535, 0, 0};
  attributesOf(scene)["JOINTS_0"] =
      addAccessor(scene, std::as_bytes(std::span(joints)), 5121, "VEC4", 3);
  attributesOf(scene)["WEIGHTS_0"] =
      addAccessor(scene, std::as_bytes(std::span(weights)), 5123, "VEC4", 3);
  scene.json["accessors"].back()["normalized"] = true;
  scene.json["skins"] = {
      {{"joints", {1, 2}},
       {"inverseBindMatrices",
        addAccessor(scene, std::as_bytes(std::span(inverseBind)), 5126, "MAT4", 2)}}};
  return scene;
}

const std::vector<float> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

std::vector<float> bothMatrices(const std::vector<float>& a, const std::vector<float>& b) {
  std::vector<float> both = a;
  both.insert(both.end(), b.begin(), b.end());
  return both;
}

/// A triangle whose one morph target moves the corner (1, 0, 0) by (0, 0, 4).
GltfScene morphedTriangle() {
  GltfScene scene = triangleScene();
  scene.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", scene.addFloats({0, 0, 0, 0, 0, 4, 0, 0, 0}, 3)}}};
  return scene;
}

} // namespace

TEST_CASE("a skinned mesh follows its joints, not its node") {
  const float half = std::sqrt(0.5f);
  std::vector<float> fromBind = kIdentity; // translation by (-1, 0, 0)
  fromBind[12] = -1.0f;
  const Scene scene = loaded(skinnedTriangle(
      {{"translation", {0, 2, 0}}}, {{"rotation", {0, 0, half, half}}, {"translation", {5, 0, 0}}},
      bothMatrices(kIdentity, fromBind)));
  const auto triangle = corners(scene);
  checkNear(triangle[0], {0, 2, 0});
  // The matrix moves it to (0, 0, 0), the rotation keeps it there, and the translation adds 5.
  checkNear(triangle[1], {5, 0, 0});
  // Joint 0 gives (0, 3, 0). Joint 1 gives (-1, 1, 0), rotated from x to y (-1, -1, 0), then (4,
  // -1, 0).
  checkNear(triangle[2], {2, 1, 0});
}

TEST_CASE("a skinned mesh keeps its shape ten million units from the origin") {
  constexpr double kFar = 1e7 + 0.1;
  const Scene scene = loaded(skinnedTriangle({{"translation", {kFar, -kFar, 0}}},
                                             {{"translation", {kFar + 0.3, -kFar, 0}}},
                                             bothMatrices(kIdentity, kIdentity)));
  const glm::dmat4& placed = scene.instances.at(0).worldFromObject;
  CHECK(glm::dvec3(placed[3]) == glm::dvec3(kFar, -kFar, 0));
  const std::vector<renderer::Vertex>& vertices = scene.primitives[0].vertices;
  checkNear(vertices[0].position, {0, 0, 0});
  checkNear(vertices[1].position, {1.3f, 0, 0});
  checkNear(vertices[2].position, {0.15f, 1, 0});
}

TEST_CASE("a mesh mirrored by its joints keeps its front outside") {
  GltfScene file = skinnedTriangle({{"scale", {-1, 1, 1}}}, {{"scale", {-1, 1, 1}}},
                                   bothMatrices(kIdentity, kIdentity));
  attributesOf(file)["NORMAL"] = file.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  const Scene scene = loaded(file);
  for (const glm::vec3 normal : {scene.primitives[0].vertices[0].normal, [&] {
                                   const auto [a, b, c] = corners(scene);
                                   return glm::normalize(glm::cross(b - a, c - a));
                                 }()})
    checkNear(normal, {0, 0, 1});
}

TEST_CASE("a skin without inverse bind matrices uses the joints' transforms") {
  GltfScene file = skinnedTriangle({{"translation", {0, 2, 0}}}, {{"translation", {0, 4, 0}}},
                                   bothMatrices(kIdentity, kIdentity));
  file.json["skins"][0].erase("inverseBindMatrices");
  const auto triangle = corners(loaded(file));
  checkNear(triangle[0], {0, 2, 0});
  checkNear(triangle[1], {1, 4, 0});
  checkNear(triangle[2], {0, 4, 0});
}

TEST_CASE("morph targets use the weights of the node, or else of the mesh, or none") {
  GltfScene file = morphedTriangle();
  checkNear(corners(loaded(file))[1], {1, 0, 0});
  file.json["meshes"][0]["weights"] = {0.5};
  checkNear(corners(loaded(file))[1], {1, 0, 2});
  // A second node of the mesh with its own weight.
  file.json["nodes"].push_back({{"mesh", 0}, {"weights", {-1}}, {"translation", {0, 0, 10}}});
  file.json["scenes"][0]["nodes"] = {0, file.json["nodes"].size() - 1};
  const Scene scene = loaded(file);
  checkNear(corners(scene, 0)[1], {1, 0, 2});
  checkNear(corners(scene, 1)[1], {1, 0, 6});
}

TEST_CASE("flat normals follow the morphed triangle") {
  GltfScene file = morphedTriangle();
  file.json["meshes"][0]["weights"] = {0.25};
  checkNear(loaded(file).primitives[0].vertices[0].normal, glm::normalize(glm::vec3(-1, 0, 1)));
}

TEST_CASE("a note says that animations are ignored") {
  GltfScene file = morphedTriangle();
  CHECK(loaded(file).notes.empty());
  file.json["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}},
       {"samplers", {{{"input", 0}, {"output", 0}}}}}};
  REQUIRE(loaded(file).notes.size() == 1);
  CHECK(loaded(file).notes[0].starts_with("animations are ignored"));
}
