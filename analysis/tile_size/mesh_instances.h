// SPDX-License-Identifier: MIT
// The nodes of a scene that draw meshes.
#pragma once

#include <lichen/gltf_scene.h>

#include <Eigen/Geometry>

namespace lichen {

struct MeshInstance {
  std::size_t node = 0;
  std::size_t mesh = 0;
  Eigen::Affine3d worldFromMesh;
};

/// The nodes of the default scene (or else the first one) that have a mesh. Skips members that
/// violate glTF, and each further visit of a node. A skin counts as its first joint.
[[nodiscard]] std::vector<MeshInstance> meshInstances(GltfScene& scene);

} // namespace lichen
