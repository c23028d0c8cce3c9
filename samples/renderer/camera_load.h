// SPDX-License-Identifier: MIT
// A glTF camera as the renderer looks through it. Private to scene loading: the model has been
// validated.
#pragma once

#include "scene.h"

#include <tiny_gltf.h>

#include <cstddef>

namespace lichen::renderer {

/// A lens that nothing can be seen through is the camera's `fault`: a scene may hold such a camera,
/// as long as it is not looked through.
[[nodiscard]] Camera readCamera(const tinygltf::Model& model, std::size_t index,
                                const glm::dmat4& worldFromCamera);

} // namespace lichen::renderer
