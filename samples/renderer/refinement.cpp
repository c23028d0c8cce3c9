// SPDX-License-Identifier: MIT
// Triangles -> smaller triangles: an edge that is too long gets a vertex in its middle, and a
// triangle becomes two to four, by the number of its edges that have one, until none has.
#include "refinement.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

namespace lichen::renderer {
namespace {

template <class Value>
Value middle(const Value& a, const Value& b) {
  return 0.5f * (a + b); // the same from both ends
}

Vertex middle(const Vertex& a, const Vertex& b) {
  Vertex m = a;
  for (const auto member : {&Vertex::position, &Vertex::normal})
    m.*member = middle(a.*member, b.*member);
  for (const auto member : {&Vertex::tangent, &Vertex::color})
    m.*member = middle(a.*member, b.*member);
  for (const auto member : {&Vertex::texCoord0, &Vertex::texCoord1})
    m.*member = middle(a.*member, b.*member);
  m.mixWeight = middle(a.mixWeight, b.mixWeight);
  return m;
}

VertexDisplacement middle(const VertexDisplacement& a, const VertexDisplacement& b) {
  return {middle(a.direction, b.direction), middle(a.weight, b.weight),
          middle(a.texCoordsPerUnit, b.texCoordsPerUnit)};
}

class Refinement {
public:
  Refinement(Primitive& mesh, const glm::dmat4& worldFromObject, float reach, const PixelView& view,
             float pixels)
      : mesh_(mesh), worldFromObject_(worldFromObject), reach_(reach), view_(view), pixels_(pixels),
        vertices_(mesh.vertices.size()) {
    const glm::mat4 rows = glm::transpose(view.clipFromEye);
    // Vulkan clips to -w <= x <= w, -w <= y <= w, 0 <= z <= w.
    planes_ = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
               rows[3] - rows[1], rows[2],           rows[3] - rows[2]};
    depth_ = rows[3];
    for (const Vertex& vertex : mesh.vertices)
      place(vertex);
  }

  /// Returns whether the vertices that it added are at most as many as it may add.
  bool run() {
    const std::vector<std::uint32_t> triangles = std::move(mesh_.indices);
    mesh_.indices.clear();
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      pending_.push_back({triangles[i], triangles[i + 1], triangles[i + 2]});
      while (!pending_.empty()) {
        const Triangle triangle = pending_.back();
        pending_.pop_back();
        divide(triangle);
        if (hasTooMany())
          return false;
      }
    }
    return true;
  }

private:
  using Triangle = std::array<std::uint32_t, 3>;

  [[nodiscard]] bool hasTooMany() const {
    return mesh_.vertices.size() - vertices_ > view_.mostVertices;
  }

  void place(const Vertex& vertex) {
    const glm::dvec4 world = worldFromObject_ * glm::dvec4(vertex.position, 1.0);
    fromEye_.emplace_back(glm::dvec3(world) - view_.eye);
  }

  /// Whether the ball around the edge, which is as wide as the edge is long, is in view. The balls
  /// of its edges cover a triangle, so one that is in view has an edge that is.
  [[nodiscard]] bool isInView(const glm::vec3& a, const glm::vec3& b, float length) const {
    const glm::vec4 center(middle(a, b), 1.0f);
    return std::all_of(planes_.begin(), planes_.end(), [&](const glm::vec4& plane) {
      return glm::dot(plane, center) + glm::length(glm::vec3(plane)) * (length / 2 + reach_) >=
             0.0f;
    });
  }

  [[nodiscard]] bool isLong(std::uint32_t i, std::uint32_t j) const {
    const glm::vec3 a = fromEye_[i], b = fromEye_[j];
    const float length = glm::length(a - b);
    const float depth =
        std::min(glm::dot(depth_, glm::vec4(a, 1)), glm::dot(depth_, glm::vec4(b, 1)));
    const float nearest = std::max(depth - glm::length(glm::vec3(depth_)) * reach_, view_.nearest);
    if (length * view_.pixelsPerUnit <= pixels_ * nearest || !isInView(a, b, length))
      return false;
    const glm::vec3 from = mesh_.vertices[i].position, to = mesh_.vertices[j].position;
    const glm::vec3 between = middle(from, to);
    return between != from && between != to; // floats end here
  }

  /// The vertex in the middle of the edge if it is too long.
  std::optional<std::uint32_t> split(std::uint32_t i, std::uint32_t j) {
    if (!isLong(i, j))
      return std::nullopt;
    const auto [low, high] = std::minmax(i, j);
    const auto [entry, isNew] =
        middles_.try_emplace(std::uint64_t(low) << 32 | high, std::uint32_t(mesh_.vertices.size()));
    if (isNew) {
      append(mesh_.vertices, i, j);
      append(mesh_.displacement, i, j);
      place(mesh_.vertices.back());
    }
    return entry->second;
  }

  template <class Value>
  static void append(std::vector<Value>& values, std::uint32_t i, std::uint32_t j) {
    if (!values.empty())
      values.push_back(middle(values[i], values[j]));
  }

  void divide(Triangle corner) {
    std::array<std::optional<std::uint32_t>, 3> edge; // edge k is from corner k to corner k + 1
    for (std::size_t k = 0; k < 3; ++k)
      edge[k] = split(corner[k], corner[(k + 1) % 3]);
    const auto count = std::count_if(edge.begin(), edge.end(), [](const auto& e) { return !!e; });
    // Turn the triangle so that edge 0 is split, and edge 2 only if all are.
    while (count % 3 != 0 && (!edge[0] || edge[2])) {
      std::rotate(corner.begin(), corner.begin() + 1, corner.end());
      std::rotate(edge.begin(), edge.begin() + 1, edge.end());
    }
    const auto [a, b, c] = corner;
    switch (count) {
    case 0:
      mesh_.indices.insert(mesh_.indices.end(), corner.begin(), corner.end());
      break;
    case 1:
      pending_.insert(pending_.end(), {Triangle{a, *edge[0], c}, Triangle{*edge[0], b, c}});
      break;
    case 2:
      pending_.insert(pending_.end(), {Triangle{*edge[0], b, *edge[1]},
                                       Triangle{a, *edge[0], *edge[1]}, Triangle{a, *edge[1], c}});
      break;
    default:
      pending_.insert(pending_.end(),
                      {Triangle{a, *edge[0], *edge[2]}, Triangle{*edge[0], b, *edge[1]},
                       Triangle{*edge[2], *edge[1], c}, Triangle{*edge[0], *edge[1], *edge[2]}});
    }
  }

  Primitive& mesh_;
  const glm::dmat4& worldFromObject_;
  float reach_;
  const PixelView& view_;
  float pixels_;
  std::size_t vertices_; ///< at first
  std::array<glm::vec4, 6> planes_{};
  glm::vec4 depth_{0.0f};
  std::vector<glm::vec3> fromEye_;                           ///< positions of the vertices
  std::unordered_map<std::uint64_t, std::uint32_t> middles_; ///< by edge
  std::vector<Triangle> pending_;
};

} // namespace

bool refine(Primitive& mesh, const glm::dmat4& worldFromObject, float reach, const PixelView& view,
            float pixels) {
  return Refinement(mesh, worldFromObject, reach, view, pixels).run();
}

} // namespace lichen::renderer
