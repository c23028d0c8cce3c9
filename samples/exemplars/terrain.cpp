// SPDX-License-Identifier: MIT
// A height field from a sum of noises. Literals are art direction, as in materials.h.
#include "terrain.h"

#include "mesh_scene.h"
#include "periodic.h"
#include "space_noise.h"

#include <array>
#include <cmath>

namespace lichen::exemplars {
namespace {

constexpr float kSideMetres = 12.0f;

/// Height in metres at a ground position in metres.
float heightAt(float x, float z) {
  const auto noise = [&](float period, std::uint32_t seed) {
    return spaceNoise({x / period, 0.0f, z / period}, seed);
  };
  return 1.3f * noise(4.3f, 21) + 0.45f * noise(1.7f, 22) + 0.1f * noise(0.6f, 23);
}

/// Slope of the ground along x and z.
std::array<float, 2> slopeAt(float x, float z) {
  constexpr float kStep = 0.05f;
  return {(heightAt(x + kStep, z) - heightAt(x - kStep, z)) / (2.0f * kStep),
          (heightAt(x, z + kStep) - heightAt(x, z - kStep)) / (2.0f * kStep)};
}

/// Position along an axis in metres, from a texture coordinate in [0, 1].
float metresAt(float texCoord) { return (texCoord - 0.5f) * kSideMetres; }

} // namespace

std::vector<std::byte> terrainGlb() {
  constexpr std::uint32_t kCells = 160; // per side
  SceneMesh mesh;
  mesh.name = "terrain";
  for (std::uint32_t j = 0; j <= kCells; ++j)
    for (std::uint32_t i = 0; i <= kCells; ++i) {
      const float u = float(i) / float(kCells), v = float(j) / float(kCells);
      const float x = metresAt(u), z = metresAt(v);
      const auto [alongX, alongZ] = slopeAt(x, z);
      const float length = std::sqrt(1.0f + alongX * alongX + alongZ * alongZ);
      mesh.positions.push_back({x, heightAt(x, z), z});
      mesh.normals.push_back({-alongX / length, 1.0f / length, -alongZ / length});
      mesh.texCoords.push_back({u, v});
    }
  constexpr std::uint32_t kRow = kCells + 1;
  for (std::uint32_t j = 0; j < kCells; ++j)
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t corner = j * kRow + i;
      for (const std::uint32_t vertex :
           {corner, corner + kRow, corner + 1, corner + 1, corner + kRow, corner + kRow + 1})
        mesh.triangles.push_back(vertex);
    }
  // Pitched down by 30 degrees.
  const std::vector<SceneCamera> cameras{
      {"view", {0.0, 5.6, 9.2}, {{-0.258819, 0.0, 0.0, 0.9659258}}}};
  return meshSceneGlb(mesh, cameras);
}

SrgbImage terrainMask(int sidePixels) {
  SrgbImage mask(sidePixels, sidePixels, 1);
  for (int y = 0; y < sidePixels; ++y)
    for (int x = 0; x < sidePixels; ++x) {
      const float alongX = metresAt((float(x) + 0.5f) / float(sidePixels));
      const float alongZ = metresAt((float(y) + 0.5f) / float(sidePixels));
      const auto [slopeX, slopeZ] = slopeAt(alongX, alongZ);
      // Adds patches of moss on rock and of rock in moss.
      const float patches = spaceNoise({alongX / 0.5f, 0.0f, alongZ / 0.5f}, 24);
      const float steep = std::sqrt(slopeX * slopeX + slopeZ * slopeZ) + 0.25f * patches;
      constexpr float kCodes = 255.0f;
      *mask.pixel(x, y) = std::floor(smoothStep(0.45f, 1.1f, steep) * kCodes + 0.5f) / kCodes;
    }
  return mask;
}

} // namespace lichen::exemplars
