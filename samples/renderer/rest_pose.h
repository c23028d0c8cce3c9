// SPDX-License-Identifier: MIT
// Morph targets and skins as a file has them before any animation.
#pragma once

#include "scene.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <span>

namespace lichen::renderer {

struct RestPose {
  std::span<const double> morphWeights;     ///< one for each target; those beyond the end are 0
  std::span<const glm::mat4> jointMatrices; ///< from the bind pose; empty without a skin
};

/// Whether a mesh stands otherwise in this pose than as its vertices are stored.
[[nodiscard]] bool deforms(const RestPose& pose);

/// How often applyRestPose() goes over the vertices.
[[nodiscard]] std::size_t restPosePasses(const tinygltf::Primitive& source, const RestPose& pose);

/// Moves positions, normals and tangents, which are those of `source` in its order, by the morph
/// targets and then by the skin, after which they are where its joints put them. Triangles that a
/// skin mirrors are turned round, and normals of `undeformed`, where it has vertices, get the
/// length that Primitive states. Errors: badInput for a joint outside the skin, or values that are
/// not finite.
[[nodiscard]] Result<void> applyRestPose(const tinygltf::Model& model,
                                         const tinygltf::Primitive& source, const RestPose& pose,
                                         Primitive& target);

} // namespace lichen::renderer
