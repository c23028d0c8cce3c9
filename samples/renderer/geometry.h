// SPDX-License-Identifier: MIT
// Converts glTF primitives into triangles. Private to scene loading.
#pragma once

#include "rest_pose.h"

namespace lichen::renderer {

/// The counts of a primitive, before anything is read. Throws a Fault.
[[nodiscard]] SourcePrimitive sourcePrimitive(const SceneFile& file, const Place& place);

/// Upper bound on the vertices and indices that readPrimitive() produces for a primitive, including
/// temporary ones.
[[nodiscard]] std::size_t expandedSize(const SourcePrimitive& source, const Material& material,
                                       const RestPose& pose);

/// A glTF primitive as indexed triangles in its rest pose. Normals are flat if the file has none;
/// tangents are present if `material` has normals from a texture or a noise. Points and lines
/// become thin solids. Returns nullopt for a primitive without positions or without a complete
/// triangle or line. The caller sets Primitive::material. Throws a Fault for an index beyond the
/// vertices, values that are not finite, or an invalid pose.
[[nodiscard]] std::optional<Primitive> readPrimitive(SceneFile& file, const SourcePrimitive& source,
                                                     const Material& material,
                                                     const RestPose& pose);

} // namespace lichen::renderer
