// SPDX-License-Identifier: MIT
// Converts glTF primitives into triangles. Private to scene loading, which has validated the model.
#pragma once

#include "rest_pose.h"
#include "scene.h"

#include <tiny_gltf.h>

#include <optional>

namespace lichen::renderer {

/// Upper bound on the vertices and indices that readPrimitive() produces for a primitive, including
/// temporary ones.
[[nodiscard]] std::size_t expandedSize(const tinygltf::Model& model,
                                       const tinygltf::Primitive& primitive,
                                       const Material& material, const RestPose& pose);

/// A glTF primitive as indexed triangles in its rest pose. Normals are flat if the file has none;
/// tangents are present if `material` has normals from a texture or a noise. Points and lines
/// become thin solids. Returns nullopt for a primitive without positions or without a complete
/// triangle or line. The caller sets Primitive::material. Errors: badInput for an index beyond the
/// vertices, values that are not finite, or an invalid pose.
[[nodiscard]] Result<std::optional<Primitive>> readPrimitive(const tinygltf::Model& model,
                                                             const tinygltf::Primitive& source,
                                                             const Material& material,
                                                             const RestPose& pose);

} // namespace lichen::renderer
