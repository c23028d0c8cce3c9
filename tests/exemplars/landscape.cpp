// SPDX-License-Identifier: MIT
// A height field from a sum of noises, over a fan of cells in front of the camera that all have a
// similar size on screen. Literals are art direction, as in materials.h.
#include "landscape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mesh_scene.h>
#include <numbers>
#include <periodic.h>
#include <space_noise.h>

namespace lichen::exemplars {
namespace {

// Cells of the fan, two triangles each.
constexpr std::uint32_t kColumns = 500;
constexpr std::uint32_t kRows = 1000;
constexpr float kHalfAngle = 40.0f * std::numbers::pi_v<float> / 180.0f; // wider than the view
constexpr float kNearest = 1.5f, kFarthest = 3000.0f;                    // metres
constexpr float kEyeHeight = 1.7f;

/// Height in metres at a ground position in metres.
float heightAt(float x, float z) {
  const float distance = std::sqrt(x * x + z * z);
  float height = 0.0f;
  std::uint32_t seed = 40;
  for (float period = 1300.0f; period > 0.5f; period *= 0.47f, ++seed) {
    const float noise = spaceNoise({x / period, 0.0f, z / period}, seed);
    const float ridge = 0.7f - 2.0f * std::abs(noise);
    // Hills start at a few times their own size from the camera, so that it does not stand inside
    // one.
    const float rise = smoothStep(0.3f * period, 2.5f * period, distance);
    height += 0.12f * period * (period > 20.0f ? rise * ridge : 0.7f * noise);
  }
  const float outcrop = spaceNoise({x / 15.0f, 0.0f, z / 15.0f}, 70);
  return height + 3.0f * smoothStep(0.4f, 0.75f, outcrop) * smoothStep(8.0f, 25.0f, distance);
}

/// Slope of the ground along x and z, over about the size of a cell there.
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

/// Noises of several periods, in [-1, 1], each fading out where cells become too large to show it.
float patchesAt(float x, float z) {
  const float distance = std::sqrt(x * x + z * z);
  float sum = 0.0f;
  std::uint32_t seed = 60;
  for (const float period : {0.4f, 2.1f, 11.0f, 60.0f}) {
    const float fade = 1.0f - smoothStep(16.0f * period, 40.0f * period, distance);
    sum += 0.25f * fade * spaceNoise({x / period, 0.0f, z / period}, seed++);
  }
  return sum;
}

/// Share of rock at a vertex, 0 to 1.
float rockAt(const SceneMesh& mesh, std::size_t vertex) {
  const auto& position = mesh.positions[vertex];
  constexpr float kUpright = 0.9f;  // y of the normal of the steepest ground that moss covers
  constexpr float kBorder = 0.012f; // half the transition's width
  const float limit = kUpright + 0.2f * patchesAt(position[0], position[2]);
  return smoothStep(-kBorder, kBorder, limit - mesh.normals[vertex][1]);
}

/// Adds a triangle as ground, as rock, or, if it has both, as ground with a blended layer of rock
/// on top.
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
  // Pitched down by 5 degrees.
  const std::vector<SceneCamera> cameras{
      {"view", {0.0, heightAt(0.0f, 0.0f) + kEyeHeight, 0.0}, {{-0.0436194, 0.0, 0.0, 0.9990482}}}};
  return meshSceneGlb(mesh, cameras);
}

} // namespace lichen::exemplars
