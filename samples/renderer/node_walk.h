// SPDX-License-Identifier: MIT
// Reads the nodes of a glTF scene. Private to scene loading, which has validated the model.
#pragma once

#include "scene.h"

#include <tiny_gltf.h>

namespace lichen::renderer {

/// Appends the primitives, instances, cameras and lights of the model's default scene (or else its
/// first scene) to `scene`, whose materials are already read. Errors: badInput for a scene without
/// anything to draw or with values that are not finite; resources for a scene beyond the bounds in
/// scene.h.
[[nodiscard]] Result<void> walkNodes(const tinygltf::Model& model, Scene& scene);

} // namespace lichen::renderer
