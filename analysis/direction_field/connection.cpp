// SPDX-License-Identifier: MIT
// Corner angles -> tangent planes and parallel transport; see connection.h.
#include "connection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::direction_field {
namespace {

using std::numbers::pi;

/// The cotangent of 5.7 degrees. The weights of sharper angles would dominate all others.
constexpr double kLargestCotangent = 10.0;

/// Corner angles and cotangents. The angles of triangles without area sum to pi too.
std::vector<double> cornerAngles(const Surface& surface, std::vector<double>& cotangents) {
  std::vector<double> angles(surface.faces.size());
  cotangents.resize(surface.faces.size());
  for (std::uint32_t c = 0; c < angles.size(); ++c) {
    const Eigen::Vector3d toNext = surface.at(nextCorner(c)) - surface.at(c);
    const Eigen::Vector3d toPrevious = surface.at(previousCorner(c)) - surface.at(c);
    const double sine = toNext.cross(toPrevious).norm();
    const double cosine = toNext.dot(toPrevious);
    angles[c] = std::atan2(sine, cosine);
    cotangents[c] = std::abs(cosine) < kLargestCotangent * sine
                        ? cosine / sine
                        : std::copysign(kLargestCotangent, cosine);
  }
  return angles;
}

/// The first corner of each fan: at the start of its border, or the least corner of a closed fan.
std::vector<std::uint32_t> firstCorners(const Surface& surface) {
  std::vector<std::uint32_t> first(surface.vertexCount(), kNone);
  for (std::uint32_t c = 0; c < surface.faces.size(); ++c)
    if (surface.twin[c] == kNone || first[surface.vertexOf[c]] == kNone)
      first[surface.vertexOf[c]] = c;
  return first;
}

/// [K13]: angles of half-edges. Scales `angles` of closed fans to sum to 2 pi.
void layOut(const Surface& surface, const std::vector<std::uint32_t>& first,
            std::vector<double>& angles, Connection& connection) {
  std::vector<double> sum(surface.vertexCount(), 0.0);
  std::vector<int> count(surface.vertexCount(), 0);
  for (std::uint32_t c = 0; c < angles.size(); ++c) {
    sum[surface.vertexOf[c]] += angles[c];
    ++count[surface.vertexOf[c]];
  }
  connection.angleOf.resize(angles.size());
  for (std::size_t v = 0; v < first.size(); ++v) {
    const bool isClosed = surface.twin[first[v]] != kNone;
    double angle = 0.0;
    std::uint32_t corner = first[v];
    do {
      if (isClosed) // a fan of zero angles has nothing to scale
        angles[corner] = sum[v] > 0.0 ? angles[corner] * (2.0 * pi / sum[v]) : 2.0 * pi / count[v];
      connection.angleOf[corner] = angle;
      angle += angles[corner];
      corner = surface.twin[previousCorner(corner)];
    } while (corner != kNone && corner != first[v]);
  }
}

/// Normals are area-weighted sums over the fan's faces, or the normal of its largest face if the
/// sum vanishes.
void setNormals(const Surface& surface, Connection& connection) {
  const std::size_t count = surface.vertexCount();
  std::vector<Eigen::Vector3d> sum(count, Eigen::Vector3d::Zero());
  std::vector<Eigen::Vector3d> largest = sum;
  connection.areaOf.assign(count, 0.0);
  for (std::uint32_t f = 0; f < surface.faceCount(); ++f) {
    const Eigen::Vector3d vector = areaVector(surface, f);
    for (std::uint32_t c = 3 * f; c < 3 * f + 3; ++c) {
      const std::uint32_t v = surface.vertexOf[c];
      sum[v] += vector;
      connection.areaOf[v] += vector.norm() / 6.0;
      if (vector.squaredNorm() > largest[v].squaredNorm())
        largest[v] = vector;
    }
  }
  constexpr double kCancelled = 1e-9; // of the area: above rounding, below any surface
  connection.normalOf.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const bool cancels = sum[v].norm() <= kCancelled * connection.areaOf[v];
    const Eigen::Vector3d& vector = cancels ? largest[v] : sum[v];
    connection.normalOf[v] =
        vector.norm() > 0.0 ? Eigen::Vector3d(vector / vector.norm()) : Eigen::Vector3d::UnitZ();
  }
  // A vertex without area would have no weight and no equation.
  constexpr double kLeastShare = 1e-6;
  double total = 0.0;
  for (const double area : connection.areaOf)
    total += area;
  const double least = total > 0.0 ? kLeastShare * total / double(count) : 1.0;
  for (double& area : connection.areaOf)
    area = std::max(area, least);
}

/// The axis of each fan comes from its half-edge most nearly perpendicular to the normal.
void setAxes(const Surface& surface, Connection& connection) {
  std::vector<double> flattest(surface.vertexCount(), 0.0);
  connection.axisOf.assign(surface.vertexCount(), Eigen::Vector3d::Zero());
  for (std::uint32_t c = 0; c < surface.faces.size(); ++c) {
    const std::uint32_t v = surface.vertexOf[c];
    const Eigen::Vector3d& normal = connection.normalOf[v];
    const Eigen::Vector3d edge = (surface.at(nextCorner(c)) - surface.at(c)).normalized();
    const Eigen::Vector3d flat = edge - normal * normal.dot(edge);
    const double length = flat.norm();
    if (!(length > flattest[v]))
      continue;
    flattest[v] = length;
    connection.axisOf[v] =
        Eigen::AngleAxisd(-connection.angleOf[c], normal) * Eigen::Vector3d(flat / length);
  }
  for (std::size_t v = 0; v < flattest.size(); ++v)
    if (flattest[v] == 0.0)
      connection.axisOf[v] = anyPerpendicular(connection.normalOf[v]);
}

} // namespace

Connection makeConnection(const Surface& surface) {
  Connection connection;
  std::vector<double> angles = cornerAngles(surface, connection.cornerCotangent);
  layOut(surface, firstCorners(surface), angles, connection);
  connection.turnOf.resize(angles.size());
  connection.curvatureOf.resize(surface.faceCount());
  for (std::uint32_t c = 0; c < angles.size(); ++c) {
    // At its end, the half-edge points opposite to the direction in which it arrives.
    const std::uint32_t end = nextCorner(c);
    connection.turnOf[c] = connection.angleOf[end] + angles[end] + pi - connection.angleOf[c];
  }
  for (std::uint32_t f = 0; f < surface.faceCount(); ++f)
    connection.curvatureOf[f] = angles[3 * f] + angles[3 * f + 1] + angles[3 * f + 2] - pi;
  setNormals(surface, connection);
  setAxes(surface, connection);
  return connection;
}

Eigen::Vector3d inSpace(const Connection& connection, std::size_t vertex, Complex direction) {
  const Eigen::Vector3d& axis = connection.axisOf[vertex];
  const Complex unit = direction / std::abs(direction);
  return unit.real() * axis + unit.imag() * connection.normalOf[vertex].cross(axis);
}

Complex inPlane(const Connection& connection, std::size_t vertex, const Eigen::Vector3d& vector) {
  const Eigen::Vector3d& axis = connection.axisOf[vertex];
  return {vector.dot(axis), vector.dot(connection.normalOf[vertex].cross(axis))};
}

Eigen::Vector3d turned(const Eigen::Vector3d& vector, const Eigen::Vector3d& from,
                       const Eigen::Vector3d& to) {
  // Rodrigues' formula, with sine * axis = from x to and cosine = from . to.
  const Eigen::Vector3d cross = from.cross(to);
  const double cosine = from.dot(to);
  return vector * cosine + cross.cross(vector) + cross * (cross.dot(vector) / (1.0 + cosine));
}

Eigen::Vector3d anyPerpendicular(const Eigen::Vector3d& normal) {
  Eigen::Vector3d::Index smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  return normal.cross(Eigen::Vector3d::Unit(smallest)).normalized();
}

} // namespace lichen::direction_field
