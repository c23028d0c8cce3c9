// SPDX-License-Identifier: MIT
// Applies a file's morph targets and skins as they are before any animation.
#pragma once

#include "scene.h"
#include "scene_file.h"

#include <span>

namespace lichen::renderer {

/// A primitive of the file.
struct SourcePrimitive {
  Place place;
  Place attributes;
  std::uint64_t mode;       ///< [glTF 2.0, section 5.24]
  std::size_t vertices = 0; ///< 0 without positions
  std::size_t stored = 0;   ///< indices in the file; without them, as many as vertices
};

struct RestPose {
  std::vector<double> morphWeights;         ///< one per target; missing ones are 0
  std::span<const glm::mat4> jointMatrices; ///< from the bind pose; empty without a skin
};

/// Whether this pose changes the stored vertices of a mesh.
[[nodiscard]] bool deforms(const RestPose& pose);

/// Number of passes that applyRestPose() makes over the vertices.
[[nodiscard]] std::size_t restPosePasses(const SourcePrimitive& source, const RestPose& pose);

/// Applies the morph targets, then the skin, to positions, normals and tangents. `target` has the
/// vertices of `source` in its order; with a skin they end up where the joints put them. Flips the
/// winding of triangles that the skin mirrors. If `undeformed` has vertices, scales their normals
/// as Primitive states. Throws a Fault for a joint outside the skin, or values that are not finite.
void applyRestPose(SceneFile& file, const SourcePrimitive& source, const RestPose& pose,
                   Primitive& target);

} // namespace lichen::renderer
