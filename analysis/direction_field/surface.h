// SPDX-License-Identifier: MIT
// Any triangles -> an oriented manifold with border, by welding, flipping and cutting.
#pragma once

#include <lichen/direction_field.h>

#include <Eigen/Dense>

#include <cstdint>
#include <numeric>
#include <vector>

namespace lichen::direction_field {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Corner c = 3 f + k of face f is at points[faces[c]]. It is also the half-edge from there to the
/// next corner of the face. Faces that share an edge have the same winding.
///
/// An edge joins two faces if exactly these two share it and their windings agree. Every other edge
/// is cut. Vertices at which faces meet without a joined edge are cut too: one *vertex* is a fan of
/// joined faces around a point.
struct Surface {
  std::vector<Eigen::Vector3d> points;      ///< welded, sorted by coordinates, in [-1, 1]
  std::vector<std::uint32_t> pointOf;       ///< per input vertex
  std::vector<std::uint32_t> faces;         ///< three points per face
  std::vector<std::uint32_t> triangleOf;    ///< per face: its input triangle
  std::vector<std::uint32_t> inputVertexOf; ///< per corner
  std::vector<std::uint32_t> twin;     ///< per half-edge: the half-edge of the other face, or kNone
  std::vector<std::uint32_t> vertexOf; ///< per corner
  std::vector<std::uint32_t> pointOfVertex;
  std::vector<std::uint32_t> componentOf; ///< per face, numbered by first faces

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

/// Skips triangles with two corners at one point, and all but one of the triangles with the same
/// three points. Positions are finite and indices in range. Throws std::bad_alloc.
[[nodiscard]] Surface makeSurface(std::span<const Vector3> positions,
                                  std::span<const std::uint32_t> triangles);

/// The unit normal of a face times twice its area.
[[nodiscard]] Eigen::Vector3d areaVector(const Surface& surface, std::uint32_t face);

class DisjointSets {
public:
  explicit DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t(0));
  }

  /// The least element of the set that contains `element`.
  [[nodiscard]] std::uint32_t find(std::uint32_t element) {
    while (parent_[element] != element)
      element = parent_[element] = parent_[parent_[element]];
    return element;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace lichen::direction_field
