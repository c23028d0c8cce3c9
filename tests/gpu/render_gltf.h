// SPDX-License-Identifier: MIT
// Builds small glTF scenes for tests: meshes and images in one binary chunk, and JSON that tests
// can edit before writing a GLB.
#pragma once

#include "../unit/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lichen::test {

class GltfScene {
public:
  GltfScene();
  /// Starts from a GLB with one buffer, such as a material library, to add meshes to it.
  explicit GltfScene(std::span<const std::byte> glb);

  nlohmann::json json;
  std::vector<std::byte> binary;

  /// Appends bytes as a bufferView, padded to 4 bytes, and returns its index.
  std::size_t addView(std::span<const std::byte> bytes);
  /// An accessor of floats: VEC2, VEC3 or VEC4 by `components`.
  std::size_t addFloats(const std::vector<float>& values, std::size_t components);
  /// An accessor of indices of 1, 2 or 4 bytes.
  std::size_t addIndices(const std::vector<std::uint32_t>& indices, std::size_t bytesEach);
  /// Adds a texture with a checkerboard of `side` x `side` cells, stored as PNG; returns the
  /// texture's index.
  std::size_t addChecker(int side, std::array<float, 3> a, std::array<float, 3> b);
  /// Adds a mesh of one primitive and a node of the scene with it.
  void addMesh(nlohmann::json attributes, std::size_t indices, std::size_t material,
               nlohmann::json node = nlohmann::json::object());
  std::size_t addMaterial(nlohmann::json material);

  /// Adds a sphere of radius 1 with normals and texture coordinates.
  void addBall(std::size_t material, nlohmann::json node = nlohmann::json::object());
  /// Adds a box of side 1.4 with normals and tangents, without texture coordinates.
  void addBox(std::size_t material, nlohmann::json node = nlohmann::json::object());
  void addGround(std::size_t material, float halfSide, float y);
  /// Adds a camera on the positive z axis that looks at the origin from `distance`.
  void addCamera(float distance, float fieldOfView, float height = 0.0f, float tilt = 0.0f);
  /// Adds a directional light from above, left and front.
  void addSun(float lux);

  [[nodiscard]] std::vector<std::byte> glb() const;
};

/// A scene with one triangle and no camera: the smallest file that loads.
[[nodiscard]] GltfScene triangleScene();

/// Writes a file into a folder and returns its path.
std::filesystem::path writeInto(const TemporaryFolder& folder, const std::string& name,
                                std::span<const std::byte> bytes);

} // namespace lichen::test
