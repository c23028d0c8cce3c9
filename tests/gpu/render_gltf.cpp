// SPDX-License-Identifier: MIT
#include "render_gltf.h"

#include <lichen/image_io.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace lichen::test {
namespace {

void appendWord(std::vector<std::byte>& bytes, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes.push_back(std::byte((value >> shift) & 0xFF));
}

} // namespace

GltfScene::GltfScene() {
  json = {{"asset", {{"version", "2.0"}}},
          {"scene", 0},
          {"scenes", {{{"nodes", nlohmann::json::array()}}}},
          {"nodes", nlohmann::json::array()},
          {"meshes", nlohmann::json::array()},
          {"accessors", nlohmann::json::array()},
          {"bufferViews", nlohmann::json::array()},
          {"buffers", {{{"byteLength", 0}}}}};
}

GltfScene::GltfScene(std::span<const std::byte> glb) : GltfScene() {
  const auto wordAt = [&](std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, glb.data() + offset, sizeof word);
    return word;
  };
  constexpr std::size_t kJsonOffset = 20;
  const std::size_t jsonSize = wordAt(12);
  const auto text = glb.subspan(kJsonOffset, jsonSize);
  const auto* begin = reinterpret_cast<const char*>(text.data());
  json.update(nlohmann::json::parse(begin, begin + text.size()));
  const auto chunk = glb.subspan(kJsonOffset + jsonSize + 8);
  binary.assign(chunk.begin(), chunk.end());
}

std::size_t GltfScene::addView(std::span<const std::byte> bytes) {
  json["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
  binary.insert(binary.end(), bytes.begin(), bytes.end());
  binary.resize((binary.size() + 3) / 4 * 4);
  json["buffers"][0]["byteLength"] = binary.size();
  return json["bufferViews"].size() - 1;
}

std::size_t GltfScene::addFloats(const std::vector<float>& values, std::size_t components) {
  const std::size_t view = addView(std::as_bytes(std::span(values)));
  json["accessors"].push_back({{"bufferView", view},
                               {"componentType", 5126},
                               {"count", values.size() / components},
                               {"type", "VEC" + std::to_string(components)}});
  return json["accessors"].size() - 1;
}

std::size_t GltfScene::addIndices(const std::vector<std::uint32_t>& indices,
                                  std::size_t bytesEach) {
  std::vector<std::byte> bytes;
  for (const std::uint32_t index : indices)
    for (std::size_t b = 0; b < bytesEach; ++b)
      bytes.push_back(std::byte((index >> (8 * b)) & 0xFF));
  const std::size_t view = addView(bytes);
  const int type = bytesEach == 1 ? 5121 : bytesEach == 2 ? 5123 : 5125;
  json["accessors"].push_back({{"bufferView", view},
                               {"componentType", type},
                               {"count", indices.size()},
                               {"type", "SCALAR"}});
  return json["accessors"].size() - 1;
}

std::size_t GltfScene::addChecker(int side, std::array<float, 3> a, std::array<float, 3> b) {
  constexpr int kCell = 8;
  SrgbImage image(side * kCell, side * kCell, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = (x / kCell + y / kCell) % 2 == 0 ? a[c] : b[c];
  const std::size_t view = addView(encodePng(image, 8).value());
  json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
  json["textures"].push_back({{"source", json["images"].size() - 1}});
  return json["textures"].size() - 1;
}

std::size_t GltfScene::addMaterial(nlohmann::json material) {
  json["materials"].push_back(std::move(material));
  return json["materials"].size() - 1;
}

void GltfScene::addMesh(nlohmann::json attributes, std::size_t indices, std::size_t material,
                        nlohmann::json node) {
  json["meshes"].push_back(
      {{"primitives",
        {{{"attributes", std::move(attributes)}, {"indices", indices}, {"material", material}}}}});
  node["mesh"] = json["meshes"].size() - 1;
  json["nodes"].push_back(std::move(node));
  json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
}

void GltfScene::addBall(std::size_t material, nlohmann::json node) {
  constexpr int kRings = 32;
  constexpr int kSegments = 64;
  constexpr double kPi = std::numbers::pi;
  std::vector<float> positions, texCoords;
  std::vector<std::uint32_t> indices;
  for (int i = 0; i <= kRings; ++i)
    for (int j = 0; j <= kSegments; ++j) {
      const double polar = kPi * i / kRings;
      const double azimuth = 2.0 * kPi * j / kSegments;
      positions.insert(positions.end(),
                       {float(std::sin(polar) * std::cos(azimuth)), float(std::cos(polar)),
                        float(-std::sin(polar) * std::sin(azimuth))});
      texCoords.insert(texCoords.end(), {2.0f * float(j) / kSegments, float(i) / kRings});
    }
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSegments; ++j) {
      const auto a = std::uint32_t(i * (kSegments + 1) + j);
      const auto b = std::uint32_t(a + kSegments + 1);
      indices.insert(indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  const std::size_t position = addFloats(positions, 3);
  addMesh({{"POSITION", position}, {"NORMAL", position}, {"TEXCOORD_0", addFloats(texCoords, 2)}},
          addIndices(indices, 2), material, std::move(node));
}

void GltfScene::addBox(std::size_t material, nlohmann::json node) {
  constexpr float kHalf = 0.7f;
  std::vector<float> positions, normals, tangents;
  std::vector<std::uint32_t> indices;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      const auto first = std::uint32_t(positions.size() / 3);
      // Corners around the face's normal, counter-clockwise from outside.
      for (const auto& [u, v] :
           {std::pair{-1.0f, -side}, {1.0f, -side}, {1.0f, side}, {-1.0f, side}}) {
        std::array<float, 3> position{}, normal{}, tangent{};
        position[std::size_t(axis)] = kHalf * side;
        position[std::size_t(axis + 1) % 3] = kHalf * u;
        position[std::size_t(axis + 2) % 3] = kHalf * v;
        normal[std::size_t(axis)] = side;
        tangent[std::size_t(axis + 1) % 3] = 1.0f;
        positions.insert(positions.end(), position.begin(), position.end());
        normals.insert(normals.end(), normal.begin(), normal.end());
        tangents.insert(tangents.end(), tangent.begin(), tangent.end());
        tangents.push_back(1.0f);
      }
      indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
  addMesh({{"POSITION", addFloats(positions, 3)},
           {"NORMAL", addFloats(normals, 3)},
           {"TANGENT", addFloats(tangents, 4)}},
          addIndices(indices, 2), material, std::move(node));
}

void GltfScene::addGround(std::size_t material, float halfSide, float y) {
  const float s = halfSide;
  addMesh({{"POSITION", addFloats({-s, y, -s, -s, y, s, s, y, s, s, y, -s}, 3)},
           {"NORMAL", addFloats({0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0}, 3)},
           {"TEXCOORD_0", addFloats({-s, -s, -s, s, s, s, s, -s}, 2)}},
          addIndices({0, 1, 2, 0, 2, 3}, 1), material);
}

void GltfScene::addCamera(float distance, float fieldOfView, float height, float tilt) {
  json["cameras"].push_back({{"type", "perspective"},
                             {"name", "front"},
                             {"perspective", {{"yfov", fieldOfView}, {"znear", 0.1}}}});
  json["nodes"].push_back({{"camera", json["cameras"].size() - 1},
                           {"translation", {0, height, distance}},
                           {"rotation", {std::sin(tilt / 2), 0, 0, std::cos(tilt / 2)}}});
  json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
}

void GltfScene::addSun(float lux) {
  json["extensionsUsed"].push_back("KHR_lights_punctual");
  json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", lux}}};
  // Rotates -z, the direction of the light, down by 50 degrees and sideways by 30.
  json["nodes"].push_back({{"rotation", {-0.4082, -0.2346, -0.1094, 0.8754}},
                           {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
}

std::vector<std::byte> GltfScene::glb() const {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::vector<std::byte> bytes;
  appendWord(bytes, 0x46546C67);
  appendWord(bytes, 2);
  appendWord(bytes, 28 + text.size() + binary.size());
  appendWord(bytes, text.size());
  appendWord(bytes, 0x4E4F534A);
  const auto characters = std::as_bytes(std::span(text));
  bytes.insert(bytes.end(), characters.begin(), characters.end());
  appendWord(bytes, binary.size());
  appendWord(bytes, 0x004E4942);
  bytes.insert(bytes.end(), binary.begin(), binary.end());
  return bytes;
}

GltfScene triangleScene() {
  GltfScene scene;
  const std::size_t material =
      scene.addMaterial({{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 0.5, 1.0}}}}});
  const std::size_t positions = scene.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
  scene.addMesh({{"POSITION", positions}}, scene.addIndices({0, 1, 2}, 2), material);
  return scene;
}

std::filesystem::path writeInto(const TemporaryFolder& folder, const std::string& name,
                                std::span<const std::byte> bytes) {
  const std::filesystem::path path = folder.path() / name;
  std::ofstream file(path, std::ios::binary); // replaceFile() would flush to disk every time
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  if (!file.flush())
    throw std::runtime_error("cannot write " + path.string());
  return path;
}

} // namespace lichen::test
