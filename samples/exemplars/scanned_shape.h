// SPDX-License-Identifier: MIT
// A mesh like a 3-D scan, for noise without texture coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lichen::exemplars {

/// Positions in metres; three vertex indices per triangle, counter-clockwise seen from outside.
struct ScannedShape {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::uint32_t> triangles;
};

/// A knobbly stone about one metre across with scan artefacts: jittering positions and holes with
/// ragged borders. No normals, no texture coordinates. The result is deterministic.
[[nodiscard]] ScannedShape scannedShape();

/// The shape as a GLB with one material, 'scan', and the cameras 'front' and 'back'. Throws
/// std::bad_alloc.
[[nodiscard]] std::vector<std::byte> scannedShapeGlb();

} // namespace lichen::exemplars
