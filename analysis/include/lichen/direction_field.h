// SPDX-License-Identifier: MIT
// A smooth field of directions on any triangle mesh: the frame of noise that needs no texture
// coordinates. docs/theory.md, "Directions on a surface", has the method.
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

/// A triangle around which the directions turn `index` times more than the surface does; not 0.
struct FieldSingularity {
  std::uint32_t triangle = 0; ///< of the input
  int index = 0;
};

/// Triangles that hang together by edges with two sides.
struct FieldComponent {
  std::size_t triangles = 0;
  bool isClosed = false; ///< has no border
  int eulerCharacteristic = 0;
  std::size_t singularities = 0;
  int indexSum = 0; ///< of a closed component its Euler characteristic [K13]
};

struct DirectionField {
  std::vector<Vector3> tangents; ///< of each vertex: a unit vector at right angles to its normal
  std::vector<Vector3> normals;  ///< of each vertex, unit: as given, else averaged by area
  std::vector<FieldSingularity> singularities; ///< in the order of their triangles
  std::vector<FieldComponent> components;      ///< in the order of their first triangles
};

/// Meshes beyond are refused: a field takes some 1.2 KB a triangle.
inline constexpr std::size_t kMostFieldTriangles = std::size_t(1) << 21;

/// The smoothest field on `positions` (finite) and `triangles` (three indices each). Vertices at
/// the same position are one, whatever their normals, so that the field is continuous across
/// seams. `normals` has one for each vertex, or none at all; a zero one is replaced.
///
/// Borders, holes, several components, edges with more than two sides, triangles wound against
/// each other, without area or given twice, and vertices without a triangle are all accepted. The
/// field does not depend on the order of vertices and triangles, but for rounding. Deterministic;
/// one thread; time grows with the triangles to the power 3/2, memory a little faster than they.
///
/// With `axis`, which is finite and of any length but 0, the field turns little and keeps to the
/// axis' part in the tangent plane, the less the shorter that part is, smoothed over a tenth of the
/// root of the surface's area: exactly on a plane that holds the axis. Singularities are then where the axis is normal to the surface. Takes twice the
/// time.
///
/// Errors: badInput for an index out of range, a position or normal that is not finite, or
/// triangles that hang together as no surface does; usage for such an axis; resources for memory or
/// too many triangles.
[[nodiscard]] Result<DirectionField> directionField(std::span<const Vector3> positions,
                                                    std::span<const std::uint32_t> triangles,
                                                    std::span<const Vector3> normals = {},
                                                    const Progress& progress = {},
                                                    const std::optional<Vector3>& axis = {});

} // namespace lichen
