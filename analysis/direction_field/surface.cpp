// SPDX-License-Identifier: MIT
// Welds by position, gives faces the same winding, and cuts where that is impossible; see
// surface.h.
#include "surface.h"

#include <algorithm>
#include <numeric>

namespace lichen::direction_field {
namespace {

/// Sets points and pointOf. Shifts and scales positions so that no later product overflows.
void weld(std::span<const Vector3> positions, Surface& surface) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  // Compares numbers, not bits: 0 and -0 are the same position.
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return positions[a] < positions[b] || (positions[a] == positions[b] && a < b);
  });
  Eigen::Array3d least = Eigen::Array3d::Constant(std::numeric_limits<double>::max());
  Eigen::Array3d most = -least;
  const auto asDouble = [&](std::uint32_t v) {
    return Eigen::Array3d(positions[v][0], positions[v][1], positions[v][2]);
  };
  surface.pointOf.resize(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || positions[order[i]] != positions[order[i - 1]])
      surface.points.push_back(asDouble(order[i]));
    surface.pointOf[order[i]] = std::uint32_t(surface.points.size() - 1);
    least = least.min(asDouble(order[i]));
    most = most.max(asDouble(order[i]));
  }
  const Eigen::Vector3d centre = (least + most) / 2.0;
  const double halfExtent = (most - least).maxCoeff() / 2.0;
  for (Eigen::Vector3d& point : surface.points)
    point = (point - centre) / (halfExtent > 0.0 ? halfExtent : 1.0);
}

/// Faces with three different points. Only the first of several faces with the same three points
/// stays.
void keepFaces(std::span<const std::uint32_t> triangles, Surface& surface) {
  struct Candidate {
    std::array<std::uint32_t, 3> points;
    std::uint32_t triangle;
    auto operator<=>(const Candidate&) const = default;
  };
  std::vector<Candidate> candidates;
  candidates.reserve(triangles.size() / 3);
  for (std::uint32_t t = 0; t < triangles.size() / 3; ++t) {
    Candidate candidate{{surface.pointOf[triangles[3 * t]], surface.pointOf[triangles[3 * t + 1]],
                         surface.pointOf[triangles[3 * t + 2]]},
                        t};
    std::sort(candidate.points.begin(), candidate.points.end());
    if (candidate.points[0] != candidate.points[1] && candidate.points[1] != candidate.points[2])
      candidates.push_back(candidate);
  }
  std::sort(candidates.begin(), candidates.end());
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (i == 0 || candidates[i].points != candidates[i - 1].points)
      surface.triangleOf.push_back(candidates[i].triangle);
  std::sort(surface.triangleOf.begin(), surface.triangleOf.end());
  for (const std::uint32_t t : surface.triangleOf)
    for (std::uint32_t k = 0; k < 3; ++k) {
      surface.inputVertexOf.push_back(triangles[3 * t + k]);
      surface.faces.push_back(surface.pointOf[triangles[3 * t + k]]);
    }
}

/// The two half-edges of an edge with exactly two faces.
struct SharedEdge {
  std::uint32_t a, b;
};

std::vector<SharedEdge> sharedEdges(const Surface& surface) {
  struct Side {
    std::uint32_t low, high, halfEdge;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  sides.reserve(surface.faces.size());
  for (std::uint32_t h = 0; h < surface.faces.size(); ++h) {
    const auto [low, high] = std::minmax(surface.faces[h], surface.faces[nextCorner(h)]);
    sides.push_back({low, high, h});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<SharedEdge> edges;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low &&
           sides[end].high == sides[begin].high)
      ++end;
    if (end - begin == 2)
      edges.push_back({sides[begin].halfEdge, sides[begin + 1].halfEdge});
  }
  return edges;
}

/// Which faces to flip so that the two faces of as many edges as possible agree. Each component has
/// two such choices; this takes the one that flips less of its area.
std::vector<bool> facesToTurn(const Surface& surface, const std::vector<SharedEdge>& edges) {
  const auto faceCount = std::uint32_t(surface.faceCount());
  std::vector<std::uint32_t> neighbour(surface.faces.size(), kNone); // across each half-edge
  for (const SharedEdge& edge : edges) {
    neighbour[edge.a] = edge.b;
    neighbour[edge.b] = edge.a;
  }
  std::vector<bool> turned(faceCount, false), seen(faceCount, false);
  std::vector<std::uint32_t> component;
  for (std::uint32_t first = 0; first < faceCount; ++first) {
    if (seen[first])
      continue;
    seen[first] = true;
    component.assign(1, first);
    double keptArea = 0.0, turnedArea = 0.0;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const std::uint32_t face = component[i];
      (turned[face] ? turnedArea : keptArea) += areaVector(surface, face).norm();
      for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
        const std::uint32_t other = neighbour[h];
        if (other == kNone || seen[other / 3])
          continue;
        const bool runsAlike = surface.faces[h] == surface.faces[other];
        seen[other / 3] = true;
        turned[other / 3] = turned[face] != runsAlike;
        component.push_back(other / 3);
      }
    }
    if (turnedArea > keptArea)
      for (const std::uint32_t face : component)
        turned[face] = !turned[face];
  }
  return turned;
}

/// Flips faces, and sets twins at edges whose two faces then agree.
void joinFaces(Surface& surface) {
  const std::vector<SharedEdge> edges = sharedEdges(surface);
  const std::vector<bool> turned = facesToTurn(surface, edges);
  for (std::uint32_t f = 0; f < turned.size(); ++f)
    if (turned[f]) {
      std::swap(surface.faces[3 * f + 1], surface.faces[3 * f + 2]);
      std::swap(surface.inputVertexOf[3 * f + 1], surface.inputVertexOf[3 * f + 2]);
    }
  // Flipping changes corners 0, 1, 2 to 0, 2, 1, and so edge 01 becomes edge 20.
  const auto moved = [&](std::uint32_t h) { return turned[h / 3] ? h - h % 3 + 2 - h % 3 : h; };
  surface.twin.assign(surface.faces.size(), kNone);
  for (const SharedEdge& edge : edges) {
    const std::uint32_t a = moved(edge.a), b = moved(edge.b);
    if (surface.faces[a] == surface.faces[b]) // for example on a Moebius strip
      continue;
    surface.twin[a] = b;
    surface.twin[b] = a;
  }
}

/// Sets vertices, from fans of joined faces, and components.
void gather(Surface& surface) {
  const auto cornerCount = std::uint32_t(surface.faces.size());
  DisjointSets fans(cornerCount), components(surface.faceCount());
  for (std::uint32_t h = 0; h < cornerCount; ++h)
    if (const std::uint32_t other = surface.twin[h]; other != kNone) {
      fans.unite(h, nextCorner(other));
      components.unite(h / 3, other / 3);
    }
  // The least element of a set comes first, so it has its number before the others need it.
  surface.vertexOf.resize(cornerCount);
  for (std::uint32_t c = 0; c < cornerCount; ++c) {
    const std::uint32_t first = fans.find(c);
    if (first == c) {
      surface.vertexOf[c] = std::uint32_t(surface.pointOfVertex.size());
      surface.pointOfVertex.push_back(surface.faces[c]);
    } else {
      surface.vertexOf[c] = surface.vertexOf[first];
    }
  }
  surface.componentOf.resize(surface.faceCount());
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < surface.faceCount(); ++f) {
    const std::uint32_t first = components.find(f);
    surface.componentOf[f] = first == f ? count++ : surface.componentOf[first];
  }
}

} // namespace

Eigen::Vector3d areaVector(const Surface& surface, std::uint32_t face) {
  const Eigen::Vector3d& a = surface.at(3 * face);
  return (surface.at(3 * face + 1) - a).cross(surface.at(3 * face + 2) - a);
}

Surface makeSurface(std::span<const Vector3> positions, std::span<const std::uint32_t> triangles) {
  Surface surface;
  weld(positions, surface);
  keepFaces(triangles, surface);
  joinFaces(surface);
  gather(surface);
  return surface;
}

} // namespace lichen::direction_field
