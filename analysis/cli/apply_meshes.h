// SPDX-License-Identifier: MIT
// `lichen apply`: checks the meshes of a scene before their materials receive a noise.
#pragma once

#include "command.h"

#include <lichen/gltf_scene.h>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// Reads the vertices of all meshes. Invalid vertices are a badInput error if the primitive uses
/// one of the materials; otherwise the primitive stays as it is and gets a note. Compressed
/// vertices, which only some viewers can read, get a note too.
[[nodiscard]] Result<void> checkMeshes(GltfScene& scene, std::span<const std::size_t> materials,
                                       std::vector<std::string>& notes);

} // namespace lichen::cli
