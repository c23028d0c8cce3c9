// SPDX-License-Identifier: MIT
// The file of a scene of one mesh with one material, and cameras.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::exemplars {

struct SceneMesh {
  std::string name; ///< of node, mesh and material
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;   ///< of each position, or none
  std::vector<std::array<float, 2>> texCoords; ///< likewise
  std::vector<std::uint32_t> triangles;        ///< three positions each, counter-clockwise
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
