// SPDX-License-Identifier: MIT
// Positions, normals and texture coordinates -> tangents [Mikkelsen, Simulation of Wrinkled
// Surfaces Revisited, 2008, appendices A and B], with the rules of his MikkTSpace, which glTF asks
// for [glTF 2.0, section 3.7.2.1]:
//   Vertices with equal position, normal and texture coordinate are welded, whatever their indices.
//   Triangles around a welded vertex form a group if they share edges and their textures have the
//   same handedness. A group has one tangent: the sum of its triangles' u directions, each
//   projected into the plane of the normal, normalised, and weighted by the triangle's angle at the
//   vertex. A triangle without area in texture space joins a neighbouring group and adds nothing to
//   the sum.
// Deviations: where all triangles at a vertex lack texture area, MikkTSpace sets the tangent to
// (1, 0, 0); this code chooses one perpendicular to the normal. MikkTSpace's v points up, glTF's
// down; this code flips v, so the fourth component is glTF's.
#include "tangents.h"

#include "directions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace lichen::renderer {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr float kTiny = std::numeric_limits<float>::min();
constexpr glm::vec3 kNoDirection{0.0f};

/// Corner 3 f + k is corner k of triangle f. Edge 3 f + k leads from that corner to the next.
std::uint32_t nextCorner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
std::uint32_t previousCorner(std::uint32_t corner) {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

struct Face {
  glm::vec3 alongU{0.0f};     ///< unit, or zero
  bool mirrored = false;      ///< its texture is mirrored, seen from the front
  bool isDegenerate = false;  ///< two corners coincide; has no neighbours
  bool joinsAnyGroup = false; ///< has no area, in texture space or in 3-D
};

class TangentGroups {
public:
  TangentGroups(Primitive& primitive, glm::vec2 Vertex::*texCoord)
      : primitive_(primitive), texCoord_(texCoord), groupOf_(primitive.indices.size(), kNone) {}

  void run() {
    weld();
    measureFaces();
    joinEdges();
    for (std::uint32_t corner = 0; corner < groupOf_.size(); ++corner)
      if (!faces_[corner / 3].joinsAnyGroup && groupOf_[corner] == kNone)
        grow(corner);
    assignRemainingCorners();
    sumDirections();
    assign();
  }

private:
  struct Group {
    std::uint32_t vertex; ///< welded vertex
    bool mirrored;
    glm::vec3 alongU{0.0f};
  };

  [[nodiscard]] const Vertex& at(std::uint32_t corner) const {
    return primitive_.vertices[primitive_.indices[corner]];
  }

  /// Maps equal vertices to the first of them.
  void weld() {
    const std::size_t count = primitive_.vertices.size();
    const auto key = [&](std::uint32_t i) {
      const Vertex& v = primitive_.vertices[i];
      const glm::vec2 t = v.*texCoord_;
      return std::make_tuple(v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y,
                             v.normal.z, t.x, t.y);
    };
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::make_pair(key(a), a) < std::make_pair(key(b), b);
    });
    std::vector<std::uint32_t> first(count);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
      first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    for (const std::uint32_t index : primitive_.indices)
      welded_.push_back(first[index]);
  }

  /// [Mikkelsen 2008] eqs. 18 and 19: the u direction of each triangle.
  void measureFaces() {
    for (std::uint32_t corner = 0; corner < welded_.size(); corner += 3) {
      const Vertex& a = at(corner);
      const Vertex& b = at(corner + 1);
      const Vertex& c = at(corner + 2);
      const glm::vec2 t1 = b.*texCoord_ - a.*texCoord_;
      const glm::vec2 t2 = c.*texCoord_ - a.*texCoord_;
      const float area = t1.y * t2.x - t1.x * t2.y; // with v pointing up
      const glm::vec3 alongU = (c.position - a.position) * t1.y - (b.position - a.position) * t2.y;
      Face face;
      face.mirrored = !(area > 0.0f);
      face.alongU = normalizedOr(face.mirrored ? -alongU : alongU, kNoDirection);
      face.isDegenerate =
          a.position == b.position || b.position == c.position || c.position == a.position;
      face.joinsAnyGroup =
          face.isDegenerate || std::abs(area) <= kTiny || face.alongU == kNoDirection;
      faces_.push_back(face);
    }
  }

  /// Pairs edges that connect the same vertices in opposite directions. If there are more than two,
  /// pairs them in triangle order.
  void joinEdges() {
    std::vector<std::uint32_t> order;
    for (std::uint32_t edge = 0; edge < welded_.size(); ++edge)
      if (!faces_[edge / 3].isDegenerate)
        order.push_back(edge);
    const auto ends = [&](std::uint32_t edge) {
      const std::uint32_t a = welded_[edge];
      const std::uint32_t b = welded_[nextCorner(edge)];
      return std::make_pair(std::min(a, b), std::max(a, b));
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::make_pair(ends(a), a) < std::make_pair(ends(b), b);
    });
    across_.assign(welded_.size(), kNone);
    std::vector<std::uint32_t> unpaired; // edges between the same two vertices
    // first edge in `unpaired` without a partner; all later ones have the same direction
    std::size_t firstUnpaired = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::uint32_t edge = order[i];
      if (i == 0 || ends(edge) != ends(order[i - 1])) {
        unpaired.clear();
        firstUnpaired = 0;
      }
      if (firstUnpaired < unpaired.size() && welded_[edge] != welded_[unpaired[firstUnpaired]]) {
        across_[edge] = unpaired[firstUnpaired];
        across_[unpaired[firstUnpaired++]] = edge;
      } else {
        unpaired.push_back(edge);
      }
    }
  }

  /// Creates a group from a corner and all corners that share its vertex across edges.
  void grow(std::uint32_t start) {
    const auto id = std::uint32_t(groups_.size());
    groups_.push_back({welded_[start], faces_[start / 3].mirrored});
    std::vector<std::uint32_t> pending{start};
    while (!pending.empty()) {
      const std::uint32_t corner = pending.back();
      pending.pop_back();
      if (!joins(corner, groups_[id]))
        continue;
      groupOf_[corner] = id;
      // Cross both edges at the corner's vertex. The vertex is the end of the first neighbouring
      // edge and the start of the second.
      if (const std::uint32_t edge = across_[previousCorner(corner)]; edge != kNone)
        pending.push_back(edge);
      if (const std::uint32_t edge = across_[corner]; edge != kNone)
        pending.push_back(nextCorner(edge));
    }
  }

  bool joins(std::uint32_t corner, const Group& group) {
    if (groupOf_[corner] != kNone)
      return false;
    Face& face = faces_[corner / 3];
    const std::uint32_t first = corner - corner % 3;
    const bool isFree =
        groupOf_[first] == kNone && groupOf_[first + 1] == kNone && groupOf_[first + 2] == kNone;
    if (face.joinsAnyGroup && isFree)
      face.mirrored = group.mirrored;
    return face.mirrored == group.mirrored;
  }

  /// Corners without a group join the first group at their vertex, or a new one.
  void assignRemainingCorners() {
    std::vector<std::uint32_t> groupAt(primitive_.vertices.size(), kNone);
    for (std::size_t g = groups_.size(); g-- > 0;)
      groupAt[groups_[g].vertex] = std::uint32_t(g);
    for (std::size_t corner = 0; corner < groupOf_.size(); ++corner) {
      if (groupOf_[corner] != kNone)
        continue;
      std::uint32_t& group = groupAt[welded_[corner]];
      if (group == kNone) {
        group = std::uint32_t(groups_.size());
        groups_.push_back({welded_[corner], false});
      }
      groupOf_[corner] = group;
    }
  }

  /// [Mikkelsen 2008] appendix A: sums u directions, weighted by angles in the plane of the normal.
  void sumDirections() {
    for (std::uint32_t corner = 0; corner < groupOf_.size(); ++corner) {
      const Face& face = faces_[corner / 3];
      if (face.joinsAnyGroup)
        continue;
      const Vertex& v = at(corner);
      const auto inPlane = [&](glm::vec3 direction) {
        return normalizedOr(direction - v.normal * glm::dot(v.normal, direction), kNoDirection);
      };
      const glm::vec3 before = inPlane(at(previousCorner(corner)).position - v.position);
      const glm::vec3 after = inPlane(at(nextCorner(corner)).position - v.position);
      const float angle = std::acos(std::clamp(glm::dot(before, after), -1.0f, 1.0f));
      groups_[groupOf_[corner]].alongU += angle * inPlane(face.alongU);
    }
  }

  /// Gives each vertex the tangent of its group; splits vertices that belong to several groups.
  void assign() {
    std::vector<Vertex>& vertices = primitive_.vertices;
    std::vector<std::uint32_t> order(groupOf_.size());
    std::iota(order.begin(), order.end(), 0u);
    const std::vector<std::uint32_t> indices = primitive_.indices;
    const auto key = [&](std::uint32_t corner) {
      return std::make_tuple(indices[corner], groupOf_[corner], corner);
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    const auto sharesVertex = [&](std::size_t i) {
      return i > 0 && indices[order[i]] == indices[order[i - 1]];
    };
    const auto isCopy = [&](std::size_t i) {
      return sharesVertex(i) && groupOf_[order[i]] != groupOf_[order[i - 1]];
    };
    std::size_t copies = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
      if (isCopy(i))
        ++copies;
    vertices.reserve(vertices.size() + copies);
    std::uint32_t vertex = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (!sharesVertex(i))
        vertex = indices[order[i]];
      if (isCopy(i)) {
        vertex = std::uint32_t(vertices.size());
        // reserved above, so this does not reallocate
        vertices.push_back(vertices[indices[order[i]]]);
      }
      primitive_.indices[order[i]] = vertex;
      vertices[vertex].tangent = tangentOf(groups_[groupOf_[order[i]]], vertices[vertex].normal);
    }
  }

  static glm::vec4 tangentOf(const Group& group, glm::vec3 normal) {
    return glm::vec4(normalizedOr(group.alongU, frameAlong(normal)[0]),
                     group.mirrored ? -1.0f : 1.0f);
  }

  Primitive& primitive_;
  glm::vec2 Vertex::*texCoord_;
  std::vector<std::uint32_t> welded_;  ///< welded vertex of each corner
  std::vector<std::uint32_t> across_;  ///< opposite edge of each edge, or kNone
  std::vector<std::uint32_t> groupOf_; ///< group of each corner
  std::vector<Face> faces_;
  std::vector<Group> groups_;
};

} // namespace

void makeTangents(Primitive& primitive, glm::vec2 Vertex::*texCoord) {
  TangentGroups(primitive, texCoord).run();
}

} // namespace lichen::renderer
