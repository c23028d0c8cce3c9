// SPDX-License-Identifier: MIT
// Tangent planes of a surface's vertices, and what carries a direction from one to the next.
// Sources: [K13].
#pragma once

#include "surface.h"

#include <complex>

namespace lichen::direction_field {

using Complex = std::complex<double>;

/// Directions at a vertex are complex numbers: e^(i t) is at the angle t, counted from the first
/// half-edge of the fan. Around a closed fan angles are stretched to a full turn, so that each
/// tangent plane is flat and all curvature lies in the faces.
struct Connection {
  std::vector<double> angleOf;     ///< of each half-edge, at its start
  std::vector<double> turnOf;      ///< of each half-edge: what a carried direction's angle grows by
  std::vector<double> curvatureOf; ///< of each face: the angle by which a direction returns turned
  std::vector<Eigen::Vector3d> normalOf; ///< of each vertex, unit
  /// Of each vertex, the unit vector at the angle 0, at right angles to its normal.
  std::vector<Eigen::Vector3d> axisOf;
  std::vector<double> areaOf;          ///< of each vertex: a third of its faces', positive
  std::vector<double> cornerCotangent; ///< bounded
};

/// Linear in the number of faces. Throws std::bad_alloc.
[[nodiscard]] Connection makeConnection(const Surface& surface);

/// The direction of a number that is not 0 at a vertex, as a unit vector, and back.
[[nodiscard]] Eigen::Vector3d inSpace(const Connection& connection, std::size_t vertex,
                                      Complex direction);
[[nodiscard]] Complex inPlane(const Connection& connection, std::size_t vertex,
                              const Eigen::Vector3d& vector);

/// A vector that turns with the least rotation that turns `from` to `to`, both unit and not
/// opposite.
[[nodiscard]] Eigen::Vector3d turned(const Eigen::Vector3d& vector, const Eigen::Vector3d& from,
                                     const Eigen::Vector3d& to);
/// A unit vector at right angles to a unit vector.
[[nodiscard]] Eigen::Vector3d anyPerpendicular(const Eigen::Vector3d& normal);

} // namespace lichen::direction_field
