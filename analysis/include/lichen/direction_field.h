// SPDX-License-Identifier: MIT
// A smooth field of directions on any triangle mesh. It gives noise a frame without texture
// coordinates. Method: docs/theory.md, "Directions on a surface".
#pragma once

#include <lichen/progress.h>
#include <lichen/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lichen {

using Vector3 = std::array<float, 3>;

/// A triangle around which the directions rotate `index` times more than the surface. Never 0.
struct FieldSingularity {
  std::uint32_t triangle = 0; ///< index into the input
  int index = 0;
};

/// Triangles connected through edges that exactly two triangles share.
struct FieldComponent {
  std::size_t triangles = 0;
  bool isClosed = false; ///< the component has no border
  int eulerCharacteristic = 0;
  std::size_t singularities = 0;
  int indexSum = 0; ///< equals the Euler characteristic if the component is closed [K13]
};

struct DirectionField {
  std::vector<Vector3> tangents; ///< per vertex: a unit vector perpendicular to the normal
  std::vector<Vector3> normals;  ///< per vertex, unit length: as given, or averaged by area
  std::vector<FieldSingularity> singularities; ///< ordered by triangle
  std::vector<FieldComponent> components;      ///< ordered by their first triangle
};

/// directionField() rejects larger meshes: it needs about 1.2 KB per triangle.
inline constexpr std::size_t kMostFieldTriangles = std::size_t(1) << 21;

/// Computes the smoothest field on `positions` (finite) and `triangles` (three indices each).
/// Vertices at the same position count as one, whatever their normals, so the field is continuous
/// across seams. `normals` has one entry per vertex or is empty; zero normals are replaced.
///
/// The mesh may have borders, holes, several components, edges with more than two triangles,
/// inconsistent winding, triangles without area, duplicate triangles and unused vertices. Up to
/// rounding, the field does not depend on the order of vertices and triangles. Deterministic; runs
/// on one thread. Time grows as the number of triangles to the power 3/2, memory slightly faster
/// than linearly.
///
/// `axis` must be finite and not 0; its length does not matter. With it the field rotates little
/// and follows the axis projected onto the tangent plane. The shorter the projection, the weaker
/// its pull, smoothed over a tenth of the square root of the surface's area. On a plane that
/// contains the axis the field follows it exactly. Singularities then lie where the axis is normal
/// to the surface. An axis doubles the time.
///
/// Errors: badInput for an index out of range, a position or normal that is not finite, or
/// triangles whose connections form no surface; usage for an axis that is 0 or not finite;
/// resources if memory runs out or there are too many triangles.
[[nodiscard]] Result<DirectionField> directionField(std::span<const Vector3> positions,
                                                    std::span<const std::uint32_t> triangles,
                                                    std::span<const Vector3> normals = {},
                                                    const Progress& progress = {},
                                                    const std::optional<Vector3>& axis = {});

} // namespace lichen
