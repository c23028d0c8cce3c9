// SPDX-License-Identifier: MIT
// Tangent planes at a surface's vertices, and the transport of directions between them.
// Source: [K13].
#pragma once

#include "surface.h"

#include <complex>

namespace lichen::direction_field {

using Complex = std::complex<double>;

/// Directions at a vertex are complex numbers: e^(i t) is at the angle t from the first half-edge
/// of the fan. Around a closed fan the angles are scaled to sum to 2 pi, so each tangent plane is
/// flat and all curvature lies in the faces.
struct Connection {
  std::vector<double> angleOf;     ///< per half-edge, at its start
  std::vector<double> turnOf;      ///< per half-edge: rotation of a direction carried along it
  std::vector<double> curvatureOf; ///< per face: rotation of a direction carried around it
  std::vector<Eigen::Vector3d> normalOf; ///< per vertex, unit
  /// Per vertex: the unit vector at the angle 0, perpendicular to the normal.
  std::vector<Eigen::Vector3d> axisOf;
  std::vector<double> areaOf;          ///< per vertex: a third of its faces' areas, positive
  std::vector<double> cornerCotangent; ///< bounded
};

/// Linear in the number of faces. Throws std::bad_alloc.
[[nodiscard]] Connection makeConnection(const Surface& surface);

/// The direction of a nonzero complex number at a vertex as a unit vector, and the reverse.
[[nodiscard]] Eigen::Vector3d inSpace(const Connection& connection, std::size_t vertex,
                                      Complex direction);
[[nodiscard]] Complex inPlane(const Connection& connection, std::size_t vertex,
                              const Eigen::Vector3d& vector);

/// Rotates a vector by the smallest rotation that takes `from` to `to`. Both are unit vectors and
/// not opposite.
[[nodiscard]] Eigen::Vector3d turned(const Eigen::Vector3d& vector, const Eigen::Vector3d& from,
                                     const Eigen::Vector3d& to);
/// A unit vector perpendicular to a unit vector.
[[nodiscard]] Eigen::Vector3d anyPerpendicular(const Eigen::Vector3d& normal);

} // namespace lichen::direction_field
