// SPDX-License-Identifier: MIT
// A point of a surface and the random points in space that reach it: the CPU twin of
// shaders_glsl/mapping/surface.glsl and noise/surface_cubes.glsl. It visits all cubes around the
// point; the shader skips those that it can rule out.
#pragma once

#include "poisson_count.h"
#include "vec3.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>
#include <lichen/surface_footprint.h>
#include <lichen/tile_footprint.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace lichen::surface {

using space::Vec3;
using Vec2 = std::array<float, 2>;

/// A point of a surface, as mappings hand it to methods.
struct Point {
  Vec3 position{};                 ///< [tile widths] from the tile origin
  Vec3 right{}, down{}, outward{}; ///< of the exemplar as it lies there, orthonormal
  TileFootprint plane;             ///< at (0, 0), with the footprint in the tangent plane
};
[[nodiscard]] Point pointAt(const SurfaceFootprint& at, const shader::LichenMaterial& material,
                            const shader::LichenNoise& noise);

/// Cubes around a point, with one impact each or a Poisson number of mean 1. Offsets from an impact
/// to the point have x and y along the tangent plane, in the method's units, and the height over
/// it, in units of that where the weight is 0.
struct Cubes {
  Vec3 place{};                        ///< offset of the point from its cube's corner
  std::array<Vec3, 3> axes{};          ///< an offset c in cubes has the components dot(axes[k], c)
  Vec3 radius{};                       ///< limits of offsets at which impacts count
  std::array<std::uint32_t, 3> cell{}; ///< the cube that holds the point
  std::uint32_t seed = 0;
  bool isPoisson = false;
  std::array<int, 3> first{}, last{}; ///< of the cubes that may reach it, from its own
};

/// Sets the place, and which cubes may reach the point. It lies at `inside` [cubes] of its own;
/// `shift` is added to all offsets. The axes, which have an inverse, and the radius are set.
void place(Cubes& cubes, const Vec3& inside, const Vec3& shift);

/// An impact that reaches a point.
struct Impact {
  Vec2 offset{};
  float weight = 0.0f;                 ///< with its sign
  std::uint32_t word = 0;              ///< its random numbers
  std::array<std::uint32_t, 3> cell{}; ///< its cube
};

/// Calls act(impact) for the impact that `word` encodes in the cube at offset `way`, if it reaches
/// the point.
template <class Act>
void actOnImpact(std::uint32_t word, const std::array<int, 3>& way, const Cubes& cubes,
                 const Act& act) {
  constexpr float kStep = 1.0f / 1024.0f; // 10 bits per axis, below the sign
  const std::array<std::uint32_t, 3> bits{word >> 21, word >> 11, word >> 1};
  Vec3 end{};
  Impact impact{.word = word};
  for (std::size_t k = 0; k < 3; ++k) {
    end[k] = float(way[k]) + (float(bits[k] & 1023u) + 0.5f) * kStep;
    impact.cell[k] = cubes.cell[k] + std::uint32_t(way[k]);
  }
  Vec3 place = cubes.place;
  for (std::size_t k = 0; k < 3; ++k) {
    place[k] -= space::dot(end, cubes.axes[k]);
    if (!(std::abs(place[k]) < cubes.radius[k]))
      return;
  }
  // [GLM17] section 6: the weight falls with the distance to the tangent plane.
  const float weight = 1.0f - std::abs(place[2]);
  impact.offset = {place[0], place[1]};
  impact.weight = (word & 0x80000000u) != 0 ? -weight : weight;
  act(impact);
}

/// Calls act(impact) for each impact that reaches the point, column by column along z, in the order
/// in which the shader sums them.
template <class Act>
void forEachImpact(const Cubes& cubes, const Act& act) {
  for (int y = cubes.first[1]; y <= cubes.last[1]; ++y)
    for (int x = cubes.first[0]; x <= cubes.last[0]; ++x) {
      const std::array<std::uint32_t, 3> column =
          pcg3d({cubes.cell[0] + std::uint32_t(x), cubes.cell[1] + std::uint32_t(y), cubes.seed});
      for (int z = cubes.first[2]; z <= cubes.last[2]; ++z) {
        const std::uint32_t cell = cubes.cell[2] + std::uint32_t(z);
        const std::uint32_t word = pcg(column[0] + cell);
        if (!cubes.isPoisson) {
          actOnImpact(word, {x, y, z}, cubes, act);
          continue;
        }
        const auto count = std::uint32_t(poissonCount(pcg(column[1] + cell)));
        for (std::uint32_t k = 0; k < count; ++k)
          actOnImpact(pcg(word + k), {x, y, z}, cubes, act);
      }
    }
}

} // namespace lichen::surface
