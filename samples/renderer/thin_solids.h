// SPDX-License-Identifier: MIT
// Converts points and lines into solids that can be lit and cast shadows.
#pragma once

#include "scene.h"

namespace lichen::renderer {

/// Vertices and indices of one solid.
inline constexpr std::size_t kThinSolidVertices = 10;
inline constexpr std::size_t kThinSolidIndices = 48;

/// Replaces segments (two indices each) with square rods with pointed ends. A segment from a vertex
/// to itself is a point and becomes an octahedron. The thickness is a fixed share of the
/// primitive's extent. The solids have their own normals and take the other attributes from the
/// segment's ends.
void makeThinSolids(Primitive& segments);

} // namespace lichen::renderer
