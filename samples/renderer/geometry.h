// SPDX-License-Identifier: MIT
// Converts glTF primitives into triangles. Private to scene loading.
#pragma once

#include "scene.h"
#include "scene_file.h"

namespace lichen::renderer {

/// A primitive of the file.
struct SourcePrimitive {
  Place place;
  Place attributes;
  std::uint64_t mode;       ///< [glTF 2.0, section 5.24]
  std::size_t vertices = 0; ///< 0 without positions
  std::size_t stored = 0;   ///< indices in the file; without them, as many as vertices
};

/// The counts of a primitive, before anything is read. Throws a Fault.
[[nodiscard]] SourcePrimitive sourcePrimitive(const SceneFile& file, const Place& place);

/// Upper bound on the vertices and indices that readPrimitive() produces for a primitive, including
/// temporary ones.
[[nodiscard]] std::size_t expandedSize(const SourcePrimitive& source);

/// A glTF primitive as indexed triangles. Normals are flat if the file has none. Returns nullopt
/// for a primitive without positions or without a complete triangle, so also for points and lines.
/// The caller sets Primitive::material. Throws a Fault for an index beyond the vertices, or values
/// that are not finite.
[[nodiscard]] std::optional<Primitive> readPrimitive(SceneFile& file, const SourcePrimitive& source,
                                                     const Material& material);

} // namespace lichen::renderer
