// SPDX-License-Identifier: MIT
// A mesh like those of a scanner, for noise that needs no texture coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lichen::exemplars {

/// Metres, and three vertices a triangle, counter-clockwise from outside.
struct ScannedShape {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::uint32_t> triangles;
};

/// A knobbly stone about a metre across: positions that jitter, holes with ragged borders, neither
/// normals nor texture coordinates. The same bytes each time.
[[nodiscard]] ScannedShape scannedShape();

/// As the file of a scene of it, with one material, 'scan', and cameras 'front' and 'back'. Throws
/// std::bad_alloc.
[[nodiscard]] std::vector<std::byte> scannedShapeGlb();

} // namespace lichen::exemplars
