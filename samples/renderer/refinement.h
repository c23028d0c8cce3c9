// SPDX-License-Identifier: MIT
// Splits the triangles of a mesh where a view shows them large.
#pragma once

#include "scene.h"

namespace lichen::renderer {

/// A camera, to measure lengths in pixels.
struct PixelView {
  glm::dvec3 eye{0.0};
  glm::mat4 clipFromEye{1.0f};  ///< of positions relative to `eye`
  float pixelsPerUnit = 1.0f;   ///< of clipFromEye; see framing.h
  float nearest = 0.0f;         ///< clip w of the near plane
  std::size_t mostVertices = 0; ///< that refine() may add
};

/// Halves edges until those in view are at most `pixels` long. An edge is measured at its end
/// nearest to the camera, as if it lay across the view, and is in view if its surface, moved by up
/// to `reach` world units, may be. All attributes are interpolated linearly. Whether an edge is
/// split, and where, depends only on the positions of its ends: coincident edges stay coincident.
/// Returns false, and leaves a part of the work done, if it would add more than
/// view.mostVertices.
[[nodiscard]] bool refine(Primitive& mesh, const glm::dmat4& worldFromObject, float reach,
                          const PixelView& view, float pixels);

} // namespace lichen::renderer
