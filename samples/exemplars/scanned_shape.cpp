// SPDX-License-Identifier: MIT
// A subdivided icosahedron whose vertices move by noise in space, without the triangles where
// another noise is high. The bare numbers are appearance, as in materials.h.
#include "scanned_shape.h"

#include <lichen/gltf_container.h>
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

/// Values of [-1, 1] at whole places, smooth between them.
float valueNoise(const Point& p, std::uint32_t seed) {
  std::array<float, 3> floors{}, weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    floors[k] = std::floor(p[k]);
    const float f = p[k] - floors[k];
    weights[k] = f * f * (3.0f - 2.0f * f);
  }
  float sum = 0.0f;
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    std::array<std::uint32_t, 3> cell{};
    float weight = 1.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t step = corner >> k & 1u;
      cell[k] = std::uint32_t(std::int32_t(floors[k])) + step;
      weight *= step != 0 ? weights[k] : 1.0f - weights[k];
    }
    constexpr float kStep = 1.0f / 32768.0f;
    const std::uint32_t hash = pcg3d({cell[0], cell[1], pcg(cell[2] + pcg(seed))})[0];
    sum += weight * (float(hash >> 16) * kStep - 1.0f);
  }
  return sum;
}

/// Each triangle becomes four.
ScannedShape subdivided(const ScannedShape& coarse) {
  ScannedShape fine{coarse.positions, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [place, isNew] =
        middles.try_emplace(std::minmax(a, b), std::uint32_t(fine.positions.size()));
    if (isNew) {
      const Point p = fine.positions[a], q = fine.positions[b];
      fine.positions.push_back(unit({p[0] + q[0], p[1] + q[1], p[2] + q[2]}));
    }
    return place->second;
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
  // Triangles of neighbours: three vertices whose directions are 63.4 degrees apart.
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

/// Where the scanner saw nothing.
bool isHole(const Point& direction) {
  return valueNoise(scaledBy(direction, 2.6f), 11) +
             0.25f * valueNoise(scaledBy(direction, 17.0f), 12) >
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
    shape.positions.push_back(scaledBy(p, 0.5f + 0.16f * valueNoise(scaledBy(p, 1.7f), 1) +
                                              0.04f * valueNoise(scaledBy(p, 5.0f), 2) +
                                              0.002f * jitter));
  }
  return shape;
}

std::vector<std::byte> scannedShapeGlb() {
  const ScannedShape shape = scannedShape();
  Point least = shape.positions.front(), most = least;
  for (const Point& p : shape.positions)
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], p[k]);
      most[k] = std::max(most[k], p[k]);
    }
  const auto positions = std::as_bytes(std::span(shape.positions));
  const auto triangles = std::as_bytes(std::span(shape.triangles));
  std::vector<std::byte> binary(positions.begin(), positions.end());
  binary.insert(binary.end(), triangles.begin(), triangles.end());
  constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertices = 34962, kIndices = 34963;
  using nlohmann::ordered_json;
  ordered_json json{{"asset", {{"version", "2.0"}, {"generator", "lichen-exemplars"}}},
                    {"scene", 0}};
  json["scenes"][0]["nodes"] = {0, 1, 2};
  json["nodes"][0] = {{"name", "scan"}, {"mesh", 0}};
  json["nodes"][1] = {{"camera", 0}, {"translation", {0.0, 0.0, 2.2}}};
  json["nodes"][2] = {
      {"camera", 1}, {"translation", {0.0, 0.0, -2.2}}, {"rotation", {0.0, 1.0, 0.0, 0.0}}};
  for (const char* name : {"front", "back"})
    json["cameras"].push_back({{"name", name},
                               {"type", "perspective"},
                               {"perspective", {{"yfov", 0.6}, {"znear", 0.1}}}});
  json["meshes"][0]["name"] = "scan";
  json["meshes"][0]["primitives"][0] = {
      {"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}};
  json["materials"][0] = {
      {"name", "scan"},
      {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}},
      {"doubleSided", true}}; // through holes the other side is seen from within
  json["accessors"][0] = {{"bufferView", 0},
                          {"componentType", kFloat},
                          {"count", shape.positions.size()},
                          {"type", "VEC3"},
                          {"min", least},
                          {"max", most}};
  json["accessors"][1] = {{"bufferView", 1},
                          {"componentType", kUnsignedInt},
                          {"count", shape.triangles.size()},
                          {"type", "SCALAR"}};
  json["bufferViews"][0] = {{"buffer", 0}, {"byteLength", positions.size()}, {"target", kVertices}};
  json["bufferViews"][1] = {{"buffer", 0},
                            {"byteOffset", positions.size()},
                            {"byteLength", triangles.size()},
                            {"target", kIndices}};
  json["buffers"][0]["byteLength"] = binary.size();
  return frameGlb(json.dump(), binary);
}

} // namespace lichen::exemplars
