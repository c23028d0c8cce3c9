// SPDX-License-Identifier: MIT
// Mesh -> surface -> smooth directions -> a tangent per vertex, and the singularities.
// Source: [K13].
#include "smoothest.h"

#include <lichen/counted.h>
#include <lichen/direction_field.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

using namespace direction_field;
using Eigen::Vector3d;

Vector3d asVector(const Vector3& v) { return {v[0], v[1], v[2]}; }
Vector3 asArray(const Vector3d& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

Result<void> checkMesh(std::span<const Vector3> positions, std::span<const std::uint32_t> triangles,
                       std::span<const Vector3> normals, const std::optional<Vector3>& axis) {
  if (triangles.size() / 3 > kMostFieldTriangles || positions.size() > 3 * kMostFieldTriangles)
    return Error{ErrorKind::resources,
                 std::to_string(triangles.size() / 3) + " triangles of " +
                     std::to_string(positions.size()) + " vertices; expected at most " +
                     std::to_string(kMostFieldTriangles) + " triangles, with three vertices each"};
  if (axis && !(asVector(*axis).norm() > 0.0 && asVector(*axis).allFinite()))
    return Error{ErrorKind::usage,
                 "an axis without a direction; expected finite numbers, not all 0"};
  if (!normals.empty() && normals.size() != positions.size())
    return Error{ErrorKind::badInput, counted(normals.size(), "normal") + " for " +
                                          std::to_string(positions.size()) + " positions"};
  for (const std::span<const Vector3> values : {positions, normals})
    for (const Vector3& value : values)
      if (!std::all_of(value.begin(), value.end(), [](float x) { return std::isfinite(x); }))
        return Error{ErrorKind::badInput, "a position or normal is not finite"};
  for (const std::uint32_t index : triangles)
    if (index >= positions.size())
      return Error{ErrorKind::badInput, "index " + std::to_string(index) +
                                            "; expected an index below " +
                                            std::to_string(positions.size())};
  return {};
}

/// The surface vertex that gives each input vertex its direction: the vertex of its first corner,
/// or another vertex at the same point; kNone if the point has no face.
std::vector<std::uint32_t> vertexOfInput(const Surface& surface) {
  std::vector<std::uint32_t> ofPoint(surface.points.size(), kNone);
  for (std::uint32_t v = 0; v < surface.vertexCount(); ++v)
    if (std::uint32_t& place = ofPoint[surface.pointOfVertex[v]]; place == kNone)
      place = v;
  std::vector<std::uint32_t> ofInput(surface.pointOf.size(), kNone);
  for (std::uint32_t c = 0; c < surface.vertexOf.size(); ++c)
    if (std::uint32_t& place = ofInput[surface.inputVertexOf[c]]; place == kNone)
      place = surface.vertexOf[c];
  for (std::size_t i = 0; i < ofInput.size(); ++i)
    if (ofInput[i] == kNone)
      ofInput[i] = ofPoint[surface.pointOf[i]];
  return ofInput;
}

/// The given normal; if it is zero or absent, the area-weighted mean over the input vertex's
/// triangles with their input winding; if those have no area, the surface's normal.
std::vector<Vector3d> inputNormals(const Surface& surface, const Connection& connection,
                                   std::span<const std::uint32_t> triangles,
                                   std::span<const Vector3> given,
                                   std::span<const std::uint32_t> vertexOf) {
  std::vector<Vector3d> sums(surface.pointOf.size(), Vector3d::Zero());
  const auto at = [&](std::size_t corner) -> const Vector3d& {
    return surface.points[surface.pointOf[triangles[corner]]];
  };
  for (std::size_t c = 0; c + 2 < triangles.size(); c += 3) {
    const Vector3d vector = (at(c + 1) - at(c)).cross(at(c + 2) - at(c));
    for (std::size_t k = 0; k < 3; ++k)
      sums[triangles[c + k]] += vector;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!given.empty() && asVector(given[i]).norm() > 0.0)
      sums[i] = asVector(given[i]);
    if (const double length = sums[i].norm(); length > 0.0)
      sums[i] /= length;
    else
      sums[i] = vertexOf[i] != kNone ? connection.normalOf[vertexOf[i]] : Vector3d::UnitZ();
  }
  return sums;
}

/// The direction at a vertex, rotated into the plane of another normal, which may point to the
/// other side.
Vector3d tangentAt(const Vector3d& direction, const Vector3d& from, const Vector3d& to) {
  const double side = from.dot(to) < 0.0 ? -1.0 : 1.0;
  const Vector3d tangent = turned(direction, side * from, to);
  return (tangent - to * to.dot(tangent)).normalized();
}

/// The angle between the directions at the ends of a half-edge, after transport along it, in
/// (-pi, pi]. The two half-edges of an edge have opposite angles.
double turning(const Surface& surface, const Connection& connection,
               const std::vector<Complex>& directions, std::uint32_t halfEdge) {
  const std::uint32_t other = surface.twin[halfEdge];
  if (other != kNone && other < halfEdge)
    return -turning(surface, connection, directions, other);
  const Complex carried =
      directions[surface.vertexOf[halfEdge]] * std::polar(1.0, connection.turnOf[halfEdge]);
  return std::arg(directions[surface.vertexOf[nextCorner(halfEdge)]] * std::conj(carried));
}

/// [K13]: a face's index is the rotation of the directions around it, curvature included, divided
/// by 2 pi.
void findSingularities(const Surface& surface, const Connection& connection,
                       const std::vector<Complex>& directions, DirectionField& field) {
  for (std::uint32_t f = 0; f < surface.faceCount(); ++f) {
    double sum = connection.curvatureOf[f];
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h)
      sum += turning(surface, connection, directions, h);
    const int index = int(std::lround(sum / (2.0 * std::numbers::pi)));
    if (index == 0)
      continue;
    field.singularities.push_back({surface.triangleOf[f], index});
    FieldComponent& component = field.components[surface.componentOf[f]];
    ++component.singularities;
    component.indexSum += index;
  }
}

/// Counts vertices - edges + faces and the other numbers of each component.
std::vector<FieldComponent> countComponents(const Surface& surface) {
  std::vector<FieldComponent> components;
  std::vector<bool> isCounted(surface.vertexCount(), false);
  for (std::uint32_t f = 0; f < surface.faceCount(); ++f) {
    if (surface.componentOf[f] == components.size())
      components.push_back({.isClosed = true});
    FieldComponent& component = components[surface.componentOf[f]];
    ++component.triangles;
    ++component.eulerCharacteristic;
    for (std::uint32_t c = 3 * f; c < 3 * f + 3; ++c) {
      const std::uint32_t other = surface.twin[c];
      component.isClosed = component.isClosed && other != kNone;
      component.eulerCharacteristic -= other == kNone || c < other ? 1 : 0;
      component.eulerCharacteristic += isCounted[surface.vertexOf[c]] ? 0 : 1;
      isCounted[surface.vertexOf[c]] = true;
    }
  }
  return components;
}

Result<DirectionField> computeField(std::span<const Vector3> positions,
                                    std::span<const std::uint32_t> triangles,
                                    std::span<const Vector3> normals, const Progress& progress,
                                    const std::optional<Vector3>& axis) {
  constexpr double kSurfaceShare = 0.05; // of the time, on a million triangles
  if (Result<void> checked = checkMesh(positions, triangles, normals, axis); !checked)
    return checked.error();
  const Surface surface = makeSurface(positions, triangles);
  const Connection connection = makeConnection(surface);
  const ProgressPart solving = ProgressPart(progress).part(kSurfaceShare, 1.0);
  const Result<std::vector<Complex>> directions =
      axis ? alignedField(surface, connection, asVector(*axis), solving)
           : smoothestField(surface, connection, solving);
  if (!directions)
    return directions.error();
  DirectionField field;
  field.components = countComponents(surface);
  findSingularities(surface, connection, directions.value(), field);
  const std::vector<std::uint32_t> vertexOf = vertexOfInput(surface);
  const std::vector<Vector3d> targets =
      inputNormals(surface, connection, triangles, normals, vertexOf);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t v = vertexOf[i];
    const Vector3d tangent = v == kNone ? anyPerpendicular(targets[i])
                                        : tangentAt(inSpace(connection, v, directions.value()[v]),
                                                    connection.normalOf[v], targets[i]);
    field.tangents.push_back(asArray(tangent));
    field.normals.push_back(asArray(targets[i]));
  }
  return field;
}

} // namespace

Result<DirectionField> directionField(std::span<const Vector3> positions,
                                      std::span<const std::uint32_t> triangles,
                                      std::span<const Vector3> normals, const Progress& progress,
                                      const std::optional<Vector3>& axis) {
  return withinMemory([] { return "not enough memory for the directions on a mesh"; },
                      [&] {
                        return unlessInterrupted("direction field", [&] {
                          return computeField(positions, triangles, normals, progress, axis);
                        });
                      });
}

} // namespace lichen
