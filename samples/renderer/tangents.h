// SPDX-License-Identifier: MIT
// Generates tangents for a mesh without any.
#pragma once

#include "scene.h"

namespace lichen::renderer {

/// Sets the tangent of every vertex that a triangle uses to the tangent space of the texture
/// coordinates `texCoord`, by MikkTSpace like exporters and bakers. Splits vertices on the edge of
/// a mirrored texture; the result has at most as many vertices as indices. Triangles keep their
/// order. O(n log n) in the number of indices; uses about 50 bytes per index.
void makeTangents(Primitive& primitive, glm::vec2 Vertex::*texCoord);

} // namespace lichen::renderer
