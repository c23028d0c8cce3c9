// SPDX-License-Identifier: MIT
// Prepares a scene for displacement: surfaces move along their normals by the height of their
// noise. See docs/decisions/011-displacement.md.
#pragma once

#include "scene.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace lichen::renderer {

/// Distance of displaced vertices in pixels, at most. A triangle misses the surface by at most
/// 1 / sqrt(3) of its longest edge times the steepness of the relief: by less than a pixel where
/// that is 1. It is also the width of the footprint that heights are filtered by.
inline constexpr float kVertexSpacing = 1.4f;

/// Over so many distances of vertices, at most, the relief fades to a border.
inline constexpr float kFadeSpacings = 64.0f;

struct Displacement {
  float depth = 0.0f; ///< world units by which the height 1 moves a surface; 0: no displacement
  float spacing = kVertexSpacing; ///< pixels
  /// That may be added: 0.4 GB, and in the worst case 0.3 GB of indices. If more are needed, the
  /// spacing is doubled until they suffice, with a note.
  std::size_t mostVertices = std::size_t(1) << 22;
};

/// What of the picture matters to the mesh.
struct DisplacementView {
  std::string camera; ///< see chooseCamera()
  std::uint32_t width = 1;
  std::uint32_t height = 1;
};

/// The scene with Material::displacement and Primitive::displacement set wherever a noise has a
/// height map, and the triangles in view refined to `spacing`. Each instance that is displaced has
/// a primitive of its own. Notes are added to the scene's. Errors: badInput if no noise has a
/// height map; errors of chooseCamera().
[[nodiscard]] Result<Scene> displacedScene(const Scene& scene, const Displacement& displacement,
                                           const DisplacementView& view);

} // namespace lichen::renderer
