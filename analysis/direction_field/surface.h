// SPDX-License-Identifier: MIT
// Any triangles -> an oriented manifold with border, by welding, turning and cutting.
#pragma once

#include <lichen/direction_field.h>

#include <Eigen/Dense>

namespace lichen::direction_field {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Corner c = 3 f + k of face f is at points[faces[c]]; it is also the half-edge from there to the
/// next corner of the face. Faces are wound alike where they share an edge.
///
/// An edge joins two faces where it has exactly these and they agree; every other edge is cut, and
/// so are vertices at which faces meet without a joined edge: one *vertex* is a fan of joined
/// faces around a point.
struct Surface {
  std::vector<Eigen::Vector3d> points;      ///< welded, in order of their coordinates, in [-1, 1]
  std::vector<std::uint32_t> pointOf;       ///< of each input vertex
  std::vector<std::uint32_t> faces;         ///< points, three a face
  std::vector<std::uint32_t> triangleOf;    ///< of each face: its input triangle
  std::vector<std::uint32_t> inputVertexOf; ///< of each corner
  std::vector<std::uint32_t> twin;          ///< of each half-edge: that of the other face, or kNone
  std::vector<std::uint32_t> vertexOf;      ///< of each corner
  std::vector<std::uint32_t> pointOfVertex;
  std::vector<std::uint32_t> componentOf; ///< of each face, numbered by first faces

  [[nodiscard]] std::size_t faceCount() const { return triangleOf.size(); }
  [[nodiscard]] std::size_t vertexCount() const { return pointOfVertex.size(); }
  [[nodiscard]] const Eigen::Vector3d& at(std::uint32_t corner) const {
    return points[faces[corner]];
  }
};

[[nodiscard]] constexpr std::uint32_t nextCorner(std::uint32_t c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}
[[nodiscard]] constexpr std::uint32_t previousCorner(std::uint32_t c) {
  return c % 3 == 0 ? c + 2 : c - 1;
}

/// Triangles with two corners at one point, and all but one of those with the same three points,
/// are left out. Positions are finite, indices in range. Throws std::bad_alloc.
[[nodiscard]] Surface makeSurface(std::span<const Vector3> positions,
                                  std::span<const std::uint32_t> triangles);

/// The normal of a face times twice its area.
[[nodiscard]] Eigen::Vector3d areaVector(const Surface& surface, std::uint32_t face);

} // namespace lichen::direction_field
