// SPDX-License-Identifier: MIT
// Points and lines as something that can be lit and cast a shadow.
#pragma once

#include "scene.h"

namespace lichen::renderer {

/// Vertices and indices of one solid.
inline constexpr std::size_t kThinSolidVertices = 10;
inline constexpr std::size_t kThinSolidIndices = 48;

/// Replaces segments, two indices each, by square rods with pointed ends; a segment from a vertex
/// to itself is a point and becomes an octahedron. They are as thick as a share of what all of the
/// primitive spans. Normals are their own; the rest of a vertex is that of the segment's end.
void makeThinSolids(Primitive& segments);

} // namespace lichen::renderer
