// SPDX-License-Identifier: MIT
// A sum of noises as a height field over a fan in front of the camera, whose cells are alike in the
// picture. The bare numbers are appearance, as in materials.h.
#include "landscape.h"

#include "mesh_scene.h"
#include "periodic.h"
#include "space_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen::exemplars {
namespace {

// Cells of the fan, two triangles each.
constexpr std::uint32_t kColumns = 500;
constexpr std::uint32_t kRows = 1000;
constexpr float kHalfAngle = 40.0f * std::numbers::pi_v<float> / 180.0f; // wider than a picture
constexpr float kNearest = 1.5f, kFarthest = 3000.0f;                    // metres
constexpr float kEyeHeight = 1.7f;

/// Metres above 0 at a place of the ground, in metres.
float heightAt(float x, float z) {
  const float distance = std::sqrt(x * x + z * z);
  float height = 0.0f;
  std::uint32_t seed = 40;
  for (float period = 1300.0f; period > 0.5f; period *= 0.47f, ++seed) {
    const float noise = spaceNoise({x / period, 0.0f, z / period}, seed);
    const float ridge = 0.7f - 2.0f * std::abs(noise);
    // Hills begin at several times their own size, so that the camera does not stand in one.
    const float rise = smoothStep(0.3f * period, 2.5f * period, distance);
    height += 0.12f * period * (period > 20.0f ? rise * ridge : 0.7f * noise);
  }
  const float outcrop = spaceNoise({x / 15.0f, 0.0f, z / 15.0f}, 70);
  return height + 3.0f * smoothStep(0.4f, 0.75f, outcrop) * smoothStep(8.0f, 25.0f, distance);
}

/// How the ground rises along x and z, over a length that a cell there can show.
std::array<float, 2> slopeAt(float x, float z) {
  const float step = 0.004f * std::sqrt(x * x + z * z) + 0.01f;
  return {(heightAt(x + step, z) - heightAt(x - step, z)) / (2.0f * step),
          (heightAt(x, z + step) - heightAt(x, z - step)) / (2.0f * step)};
}

void addVertices(SceneMesh& mesh) {
  for (std::uint32_t j = 0; j <= kRows; ++j) {
    const float distance = kNearest * std::pow(kFarthest / kNearest, float(j) / float(kRows));
    for (std::uint32_t i = 0; i <= kColumns; ++i) {
      const float angle = (2.0f * float(i) / float(kColumns) - 1.0f) * kHalfAngle;
      const float x = distance * std::sin(angle), z = -distance * std::cos(angle);
      const auto [alongX, alongZ] = slopeAt(x, z);
      const float length = std::sqrt(1.0f + alongX * alongX + alongZ * alongZ);
      mesh.positions.push_back({x, heightAt(x, z), z});
      mesh.normals.push_back({-alongX / length, 1.0f / length, -alongZ / length});
    }
  }
}

/// Of [-1, 1]: noises of many sizes, each up to where a cell can no longer show it.
float patchesAt(float x, float z) {
  const float distance = std::sqrt(x * x + z * z);
  float sum = 0.0f;
  std::uint32_t seed = 60;
  for (const float period : {0.4f, 2.1f, 11.0f, 60.0f}) {
    const float shown = 1.0f - smoothStep(16.0f * period, 40.0f * period, distance);
    sum += 0.25f * shown * spaceNoise({x / period, 0.0f, z / period}, seed++);
  }
  return sum;
}

/// How much of a vertex is rock, 0 to 1.
float rockAt(const SceneMesh& mesh, std::size_t vertex) {
  const auto& place = mesh.positions[vertex];
  constexpr float kUpright = 0.9f;  // y of the normal of ground that moss still holds on to
  constexpr float kBorder = 0.012f; // within which it gets thin
  const float limit = kUpright + 0.2f * patchesAt(place[0], place[2]);
  return smoothStep(-kBorder, kBorder, limit - mesh.normals[vertex][1]);
}

/// Ground, rock, or ground below and a layer of rock above, where a triangle has both.
void addTriangle(SceneMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const auto [least, most] = std::minmax({mesh.alphas[a], mesh.alphas[b], mesh.alphas[c]});
  const auto add = [&](std::vector<std::uint32_t>& triangles) {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  };
  if (least < 1.0f)
    add(mesh.triangles);
  else
    add(mesh.otherParts[0].triangles);
  if (least < 1.0f && most > 0.0f)
    add(mesh.otherParts[1].triangles);
}

} // namespace

std::vector<std::byte> landscapeGlb() {
  SceneMesh mesh;
  mesh.name = "ground";
  addVertices(mesh);
  mesh.otherParts.push_back({"rock", {}, false});
  mesh.otherParts.push_back({"rock edge", {}, true});
  for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex)
    mesh.alphas.push_back(rockAt(mesh, vertex));
  constexpr std::uint32_t kRow = kColumns + 1;
  for (std::uint32_t j = 0; j < kRows; ++j)
    for (std::uint32_t i = 0; i < kColumns; ++i) {
      const std::uint32_t corner = j * kRow + i;
      for (const std::array<std::uint32_t, 3>& triangle :
           {std::array{corner, corner + 1, corner + kRow},
            std::array{corner + 1, corner + kRow + 1, corner + kRow}})
        addTriangle(mesh, triangle);
    }
  // Downwards by 5 degrees.
  const std::vector<SceneCamera> cameras{
      {"view", {0.0, heightAt(0.0f, 0.0f) + kEyeHeight, 0.0}, {{-0.0436194, 0.0, 0.0, 0.9990482}}}};
  return meshSceneGlb(mesh, cameras);
}

} // namespace lichen::exemplars
