// SPDX-License-Identifier: MIT
// Triangles out of a glTF primitive. Private to scene loading: the model has been validated.
#pragma once

#include "rest_pose.h"
#include "scene.h"

#include <tiny_gltf.h>

#include <optional>

namespace lichen::renderer {

/// Vertices and indices that readPrimitive() makes of a primitive at most, and needs on the way.
[[nodiscard]] std::size_t expandedSize(const tinygltf::Model& model,
                                       const tinygltf::Primitive& primitive,
                                       const Material& material, const RestPose& pose);

/// A glTF primitive as indexed triangles in its rest pose, with normals (flat where the file has
/// none), and tangents where `material` has normals of a texture or a noise. Points and lines
/// become thin solids. Nothing for primitives without positions or without a whole triangle or
/// line. Primitive::material is left to the caller. Errors: badInput for an index beyond the
/// vertices, values that are not finite, or the pose.
[[nodiscard]] Result<std::optional<Primitive>> readPrimitive(const tinygltf::Model& model,
                                                             const tinygltf::Primitive& source,
                                                             const Material& material,
                                                             const RestPose& pose);

} // namespace lichen::renderer
