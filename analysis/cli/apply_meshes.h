// SPDX-License-Identifier: MIT
// What `lichen apply` says of the meshes of a scene before it gives their materials a noise.
#pragma once

#include "command.h"

#include <lichen/gltf_scene.h>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// Reads the vertices of all meshes. A fault in what has one of the materials is an error,
/// badInput; one elsewhere in the scene, which stays as it is, a note; vertices that are compressed
/// a note too, since other viewers may read them.
[[nodiscard]] Result<void> checkMeshes(GltfScene& scene, std::span<const std::size_t> materials,
                                       std::vector<std::string>& notes);

} // namespace lichen::cli
