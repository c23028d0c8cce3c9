// SPDX-License-Identifier: MIT
// Materials, textures and images of a glTF model. Private to scene loading: the model has been
// validated.
#pragma once

#include "scene.h"

#include <tiny_gltf.h>

namespace lichen::renderer {

/// Fills scene.materials (with glTF's default material last) and scene.images, decoding each image
/// that a material uses; image bytes are in tinygltf::Image::image as the file holds them.
[[nodiscard]] Result<void> readMaterials(const tinygltf::Model& model, Scene& scene);

} // namespace lichen::renderer
