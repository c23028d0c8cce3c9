// SPDX-License-Identifier: MIT
// Triangles out of glTF accessors. Private to scene loading: the model has been validated.
#pragma once

#include "scene.h"

#include <tiny_gltf.h>

#include <optional>
#include <vector>

namespace lichen::renderer {

/// The accessor's values as floats, componentCount(type) interleaved; normalized integers become
/// [0, 1] or [-1, 1], sparse values are applied. Errors: badInput for NaN, Inf, or a sparse index
/// outside the accessor.
[[nodiscard]] Result<std::vector<float>> readAccessor(const tinygltf::Model& model, int accessor);

/// Vertices and indices that readPrimitive() makes of a primitive at most, and needs on the way.
[[nodiscard]] std::size_t expandedSize(const tinygltf::Model& model,
                                       const tinygltf::Primitive& primitive,
                                       const Material& material);

/// A glTF primitive as indexed triangles with normals (flat where the file has none), and tangents
/// where `material` has normals of a texture or a noise. Nothing for points, lines, and primitives
/// without positions or triangles. Primitive::material is left to the caller.
/// Errors: badInput for an index beyond the vertices.
[[nodiscard]] Result<std::optional<Primitive>> readPrimitive(const tinygltf::Model& model,
                                                             const tinygltf::Primitive& primitive,
                                                             const Material& material);

} // namespace lichen::renderer
