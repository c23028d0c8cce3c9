// SPDX-License-Identifier: MIT
// The file of a scene of one mesh, with a material or several, and cameras.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::exemplars {

/// Triangles of a mesh with a material of their own.
struct ScenePart {
  std::string material;
  std::vector<std::uint32_t> triangles; ///< as SceneMesh::triangles
  bool isBlended = false;               ///< by SceneMesh::alphas
};

struct SceneMesh {
  std::string name; ///< of node, mesh and first material
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;   ///< of each position, or none
  std::vector<std::array<float, 2>> texCoords; ///< likewise
  std::vector<float> alphas;                   ///< likewise, in [0, 1], of 8 bits in the file
  std::vector<std::uint32_t> triangles;        ///< three positions each, counter-clockwise
  std::vector<ScenePart> otherParts;           ///< of the same positions
  bool isDoubleSided = false;
};

struct SceneCamera {
  const char* name;
  std::array<double, 3> translation{};
  std::optional<std::array<double, 4>> rotation; ///< a quaternion, w last
};

/// As a GLB. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> meshSceneGlb(const SceneMesh& mesh,
                                                  std::span<const SceneCamera> cameras);

} // namespace lichen::exemplars
