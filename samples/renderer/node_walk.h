// SPDX-License-Identifier: MIT
// The nodes of a glTF scene. Private to scene loading: the model has been validated.
#pragma once

#include "scene.h"

#include <tiny_gltf.h>

namespace lichen::renderer {

/// Appends to `scene`, whose materials are read already, what stands in the model's default scene,
/// or else in its first: primitives and their instances, cameras and lights. Errors: badInput for a
/// scene without anything to draw, or with values that are not finite; resources for one larger
/// than the bounds in scene.h.
[[nodiscard]] Result<void> walkNodes(const tinygltf::Model& model, Scene& scene);

} // namespace lichen::renderer
