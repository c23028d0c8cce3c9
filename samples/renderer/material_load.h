// SPDX-License-Identifier: MIT
// Reads the materials, textures and images of a glTF model. Private to scene loading, which has
// validated the model.
#pragma once

#include "scene.h"

#include <tiny_gltf.h>

namespace lichen::renderer {

/// Fills scene.materials (glTF's default material comes last) and scene.images. Decodes each image
/// that a material uses; tinygltf::Image::image holds the encoded file.
[[nodiscard]] Result<void> readMaterials(const tinygltf::Model& model, Scene& scene);

} // namespace lichen::renderer
