// SPDX-License-Identifier: MIT
// Tangents of a mesh that has none.
#pragma once

#include "scene.h"

namespace lichen::renderer {

/// The frame that the normals of a texture read at `texCoord` are in, as exporters and bakers have
/// it: MikkTSpace. Sets the tangent of every vertex that a triangle uses. Where a vertex lies on
/// the edge of a mirrored texture it gets a copy for either side, at most as many vertices as there
/// are indices. Triangles keep their order. Time n log n in the indices; some 50 bytes for each
/// while it runs.
void makeTangents(Primitive& primitive, glm::vec2 Vertex::*texCoord);

} // namespace lichen::renderer
