// SPDX-License-Identifier: MIT
// Reads the materials, textures and images of a glTF file. Private to scene loading.
#pragma once

#include "scene.h"
#include "scene_file.h"

namespace lichen::renderer {

/// Fills scene.materials (glTF's default material comes last) and scene.images. Decodes each image
/// that a material uses. Throws a Fault.
void readMaterials(SceneFile& file, Scene& scene);

} // namespace lichen::renderer
