// SPDX-License-Identifier: MIT
// Converts a glTF camera into the renderer's Camera. Private to scene loading, which has validated
// the model.
#pragma once

#include "scene.h"

#include <tiny_gltf.h>

#include <cstddef>

namespace lichen::renderer {

/// Stores an unusable projection as the camera's `fault` instead of failing: a scene may contain
/// such a camera, as long as nobody renders with it.
[[nodiscard]] Camera readCamera(const tinygltf::Model& model, std::size_t index,
                                const glm::dmat4& worldFromCamera);

} // namespace lichen::renderer
