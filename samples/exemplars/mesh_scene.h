// SPDX-License-Identifier: MIT
// Writes a scene with one mesh, one or more materials, and cameras.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::exemplars {

/// Triangles of a mesh that have their own material.
struct ScenePart {
  std::string material;
  std::vector<std::uint32_t> triangles; ///< like SceneMesh::triangles
  bool isBlended = false;               ///< blended by SceneMesh::alphas
};

struct SceneMesh {
  std::string name; ///< name of the node, the mesh and the first material
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;   ///< one per position, or empty
  std::vector<std::array<float, 2>> texCoords; ///< one per position, or empty
  std::vector<float> alphas; ///< one per position, or empty; in [0, 1], stored with 8 bits
  std::vector<std::uint32_t> triangles; ///< indices, three per triangle, counter-clockwise
  std::vector<ScenePart> otherParts;    ///< share the positions
  bool isDoubleSided = false;
};

struct SceneCamera {
  const char* name;
  std::array<double, 3> translation{};
  std::optional<std::array<double, 4>> rotation; ///< quaternion, w last
};

/// Returns the scene as a GLB. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> meshSceneGlb(const SceneMesh& mesh,
                                                  std::span<const SceneCamera> cameras);

} // namespace lichen::exemplars
