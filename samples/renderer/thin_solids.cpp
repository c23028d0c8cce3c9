// SPDX-License-Identifier: MIT
// Segments -> rods; see thin_solids.h. glTF does not define the width of points and lines.
#include "thin_solids.h"

#include "directions.h"

#include <array>

namespace lichen::renderer {
namespace {

// Share of the bounding box's diagonal. The rods are 2 pixels thick if the box fills a picture of
// 250 pixels, and leave two thirds of the spacing open in a grid of 32 x 32 points.
constexpr float kRadiusShare = 0.004f;
constexpr std::uint32_t kSides = 4;

float radiusOf(const std::vector<Vertex>& vertices, const std::vector<std::uint32_t>& indices) {
  glm::vec3 low = vertices[indices.front()].position;
  glm::vec3 high = low;
  for (const std::uint32_t i : indices) {
    low = glm::min(low, vertices[i].position);
    high = glm::max(high, vertices[i].position);
  }
  const float diagonal = glm::length(high - low);
  return kRadiusShare * (diagonal > 0.0f ? diagonal : 1.0f);
}

/// Adds four corners around an end, and its tip.
void addEnd(std::vector<Vertex>& vertices, const Vertex& end, const glm::mat3& frame, float radius,
            float outward) {
  for (std::uint32_t side = 0; side < kSides; ++side) {
    Vertex corner = end;
    corner.normal = frame[int(side % 2)] * (side < 2 ? 1.0f : -1.0f);
    corner.position += radius * corner.normal;
    vertices.push_back(corner);
  }
  Vertex tip = end;
  tip.normal = outward * frame[2];
  tip.position += radius * tip.normal;
  vertices.push_back(tip);
}

void addTriangles(std::vector<std::uint32_t>& indices, std::uint32_t first) {
  constexpr std::uint32_t kTip = kSides;
  const std::uint32_t other = first + kSides + 1;
  for (std::uint32_t side = 0; side < kSides; ++side) {
    const std::uint32_t next = (side + 1) % kSides;
    indices.insert(indices.end(), {first + side, first + next, other + next, //
                                   first + side, other + next, other + side, //
                                   first + next, first + side, first + kTip, //
                                   other + side, other + next, other + kTip});
  }
}

} // namespace

void makeThinSolids(Primitive& segments) {
  const float radius = radiusOf(segments.vertices, segments.indices);
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  vertices.reserve(segments.indices.size() / 2 * kThinSolidVertices);
  indices.reserve(segments.indices.size() / 2 * kThinSolidIndices);
  for (std::size_t i = 0; i + 1 < segments.indices.size(); i += 2) {
    const Vertex& start = segments.vertices[segments.indices[i]];
    const Vertex& end = segments.vertices[segments.indices[i + 1]];
    const glm::mat3 frame =
        frameAlong(normalizedOr(end.position - start.position, glm::vec3(0, 1, 0)));
    const auto first = std::uint32_t(vertices.size());
    addEnd(vertices, start, frame, radius, -1.0f);
    addEnd(vertices, end, frame, radius, 1.0f);
    addTriangles(indices, first);
  }
  segments.vertices = std::move(vertices);
  segments.indices = std::move(indices);
}

} // namespace lichen::renderer
