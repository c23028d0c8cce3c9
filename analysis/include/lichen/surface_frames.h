// SPDX-License-Identifier: MIT
// Adds the tangents that surface noise needs to a glTF asset that has none.
#pragma once

#include <lichen/direction_field.h>
#include <lichen/gltf_scene.h>

#include <string>

namespace lichen {

/// A point where the directions on a mesh cannot be smooth.
struct FrameSingularity {
  Vector3 position{}; ///< the centre of a triangle, in the mesh's space
  int index = 0;
};

/// What addSurfaceFrames() added to the primitives of one mesh.
struct MeshFrames {
  std::string mesh; ///< "mesh 'rock'"
  std::size_t triangles = 0;
  bool hasNewNormals = false; ///< at least one primitive got normals
  std::vector<FieldComponent> components;
  std::vector<FrameSingularity> singularities;
};

struct FrameOptions {
  /// The axis of directionField(), in each mesh's own space; empty for the smoothest field.
  std::optional<Vector3> grain;
  /// The noise brings its own normals, so no normalTexture of a material is used.
  bool bringsNormals = false;
};

/// Whether a primitive has tangents, and the normals that belong to them.
[[nodiscard]] bool hasFrame(const GltfScene& scene, PrimitivePlace place);

/// Checks that new frames for a material's primitives replace no tangents that are in use. Errors:
/// badInput, naming the first primitive whose material needs tangents of its texture coordinates.
[[nodiscard]] Result<void> checkFrames(const GltfScene& scene, std::size_t material,
                                       bool bringsNormals);

/// Adds TANGENT (w = 1) to the primitives of these materials that have none. If NORMAL is absent
/// too, adds normals averaged by area; tangents without normals are ignored and replaced. All such
/// primitives of a mesh share one field.
/// Errors, naming the primitive: badInput for what GltfScene::geometry() or directionField()
/// rejects, and as checkFrames(); usage for a grain that directionField() rejects; resources.
[[nodiscard]] Result<std::vector<MeshFrames>>
addSurfaceFrames(GltfScene& scene, std::span<const std::size_t> materials,
                 const FrameOptions& options = {}, const Progress& progress = {});

} // namespace lichen
