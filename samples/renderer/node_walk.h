// SPDX-License-Identifier: MIT
// Reads the nodes of a glTF scene. Private to scene loading.
#pragma once

#include "scene.h"
#include "scene_file.h"

namespace lichen::renderer {

/// Appends the primitives, instances, cameras and lights of the file's default scene (or else its
/// first scene) to `scene`, whose materials are already read. Throws a Fault, of the kind resources
/// for a scene beyond the bounds in scene.h.
void walkNodes(SceneFile& file, Scene& scene);

} // namespace lichen::renderer
