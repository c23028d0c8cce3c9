// SPDX-License-Identifier: MIT
// Converts a glTF camera into the renderer's Camera. Private to scene loading.
#pragma once

#include "json_place.h"
#include "scene.h"

namespace lichen::renderer {

/// Stores an unusable projection as the camera's `fault`: a scene may contain such a camera, as
/// long as nobody renders with it. Appends a note for a member that is ignored. Throws a Fault for
/// members of the wrong type.
[[nodiscard]] Camera readCamera(const Place& source, const glm::dmat4& worldFromCamera,
                                std::vector<std::string>& notes);

} // namespace lichen::renderer
