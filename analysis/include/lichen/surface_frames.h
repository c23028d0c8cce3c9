// SPDX-License-Identifier: MIT
// The frames of surface noise in a glTF asset: tangents where it has none.
#pragma once

#include <lichen/direction_field.h>
#include <lichen/gltf_scene.h>

#include <string>

namespace lichen {

/// Where the directions on a mesh cannot be smooth.
struct FrameSingularity {
  Vector3 position{}; ///< the middle of a triangle, in the mesh's space
  int index = 0;
};

/// What was added to the primitives of one mesh.
struct MeshFrames {
  std::string mesh; ///< "mesh 'rock'"
  std::size_t triangles = 0;
  bool hasNewNormals = false; ///< for at least one primitive
  std::vector<FieldComponent> components;
  std::vector<FrameSingularity> singularities;
};

struct FrameOptions {
  /// The axis of directionField(), in each mesh's own space; nothing for the smoothest field.
  std::optional<Vector3> grain;
  /// What lies on the frames has normals of its own: no normalTexture of a material is read.
  bool bringsNormals = false;
};

/// Whether the frames of a material's primitives would take the place of no other tangents. Errors:
/// badInput, naming the first primitive whose material needs tangents of its texture coordinates.
[[nodiscard]] Result<void> checkFrames(const GltfScene& scene, std::size_t material,
                                       bool bringsNormals);

/// Adds TANGENT (w = 1) to the primitives of these materials that have none, and NORMAL averaged by
/// area where that is absent too: tangents then count for nothing and are replaced. One field for
/// all such primitives of a mesh.
/// Errors, naming the primitive: badInput for what GltfScene::geometry() or directionField()
/// refuses, and as checkFrames(); usage for a grain that directionField() refuses; resources.
[[nodiscard]] Result<std::vector<MeshFrames>>
addSurfaceFrames(GltfScene& scene, std::span<const std::size_t> materials,
                 const FrameOptions& options = {}, const Progress& progress = {});

} // namespace lichen
