// SPDX-License-Identifier: MIT
// A subdivided icosahedron, displaced by 3-D noise, without the triangles where another noise is
// high. Literals are art direction, as in materials.h.
#include "scanned_shape.h"

#include "mesh_scene.h"
#include "space_noise.h"

#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lichen::exemplars {
namespace {

using Point = std::array<float, 3>;

Point scaledBy(const Point& p, float factor) {
  return {p[0] * factor, p[1] * factor, p[2] * factor};
}

Point unit(const Point& p) {
  return scaledBy(p, 1.0f / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
}

/// Splits each triangle into four.
ScannedShape subdivided(const ScannedShape& coarse) {
  ScannedShape fine{coarse.positions, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, isNew] =
        middles.try_emplace(std::minmax(a, b), std::uint32_t(fine.positions.size()));
    if (isNew) {
      const Point p = fine.positions[a], q = fine.positions[b];
      fine.positions.push_back(unit({p[0] + q[0], p[1] + q[1], p[2] + q[2]}));
    }
    return entry->second;
  };
  for (std::size_t t = 0; t < coarse.triangles.size(); t += 3) {
    const std::uint32_t a = coarse.triangles[t], b = coarse.triangles[t + 1],
                        c = coarse.triangles[t + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::uint32_t vertex : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca})
      fine.triangles.push_back(vertex);
  }
  return fine;
}

ScannedShape icosahedron() {
  constexpr float kGolden = 1.61803399f;
  ScannedShape shape;
  for (const float y : {1.0f, -1.0f})
    for (const float z : {kGolden, -kGolden})
      for (const Point& p : {Point{0.0f, y, z}, Point{y, z, 0.0f}, Point{z, 0.0f, y}})
        shape.positions.push_back(unit(p));
  // Each triangle connects three neighbours: vertices whose directions are 63.4 degrees apart.
  const auto dot = [&](std::uint32_t a, std::uint32_t b) {
    const Point &p = shape.positions[a], &q = shape.positions[b];
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  const auto isOutward = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Point &p = shape.positions[a], &q = shape.positions[b], &r = shape.positions[c];
    return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]) >
           0.0f;
  };
  const auto count = std::uint32_t(shape.positions.size());
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a + 1; b < count; ++b)
      for (std::uint32_t c = b + 1; c < count; ++c)
        if (dot(a, b) > 0.0f && dot(b, c) > 0.0f && dot(c, a) > 0.0f)
          for (const std::uint32_t vertex :
               {a, isOutward(a, b, c) ? b : c, isOutward(a, b, c) ? c : b})
            shape.triangles.push_back(vertex);
  return shape;
}

/// Whether the scan has a hole in this direction.
bool isHole(const Point& direction) {
  return spaceNoise(scaledBy(direction, 2.6f), 11) +
             0.25f * spaceNoise(scaledBy(direction, 17.0f), 12) >
         0.52f;
}

} // namespace

ScannedShape scannedShape() {
  ScannedShape ball = icosahedron();
  constexpr int kSubdivisions = 5;
  for (int k = 0; k < kSubdivisions; ++k)
    ball = subdivided(ball);
  ScannedShape shape;
  for (std::size_t t = 0; t < ball.triangles.size(); t += 3) {
    const std::uint32_t* corners = &ball.triangles[t];
    if (!std::all_of(corners, corners + 3,
                     [&](std::uint32_t v) { return isHole(ball.positions[v]); }))
      shape.triangles.insert(shape.triangles.end(), corners, corners + 3);
  }
  for (std::uint32_t v = 0; v < ball.positions.size(); ++v) {
    const Point& p = ball.positions[v];
    const float jitter = float(pcg(v) >> 16) * (1.0f / 65536.0f) - 0.5f;
    shape.positions.push_back(scaledBy(p, 0.5f + 0.16f * spaceNoise(scaledBy(p, 1.7f), 1) +
                                              0.04f * spaceNoise(scaledBy(p, 5.0f), 2) +
                                              0.002f * jitter));
  }
  return shape;
}

std::vector<std::byte> scannedShapeGlb() {
  ScannedShape shape = scannedShape();
  SceneMesh mesh;
  mesh.name = "scan";
  mesh.positions = std::move(shape.positions);
  mesh.triangles = std::move(shape.triangles);
  mesh.isDoubleSided = true; // the inside is visible through the holes
  const std::vector<SceneCamera> cameras{{"front", {0.0, 0.0, 2.2}, {}},
                                         {"back", {0.0, 0.0, -2.2}, {{0.0, 1.0, 0.0, 0.0}}}};
  return meshSceneGlb(mesh, cameras);
}

} // namespace lichen::exemplars
