// SPDX-License-Identifier: MIT
// The impacts of a texton noise that reach a point of a surface: the CPU twin of
// shaders_glsl/noise/surface_impacts.glsl and mapping/surface.glsl. It visits all cubes around the
// point; the shader skips those that it can rule out.
#pragma once

#include "impacts.h"

#include <lichen/surface_footprint.h>

#include <array>
#include <cmath>

namespace lichen::texton {

using Vec3 = std::array<float, 3>;

/// Values that all maps of a surface noise share at one point. Offsets between cubes are in cubes,
/// from the corner of the cube that holds the point. The offset of the point from an impact has
/// three parts: two in texels, from the centre of the area that the texton covers, and the height
/// over the tangent plane, in units of the largest height that has a weight.
struct SurfaceImpacts {
  Impacts impacts;                     ///< of a plane with this footprint
  Vec3 place{};                        ///< offset of the point from its cube's corner
  std::array<Vec3, 3> axes{};          ///< map an offset in cubes to texels and height
  Vec3 radius{};                       ///< limits of offsets at which impacts count
  std::array<std::uint32_t, 3> cell{}; ///< the cube that holds the point
  std::array<int, 3> first{}, last{};  ///< offsets of the cubes that may reach it
};

[[nodiscard]] SurfaceImpacts surfaceImpactsAt(const SurfaceFootprint& at,
                                              const shader::LichenMaterial& material,
                                              const shader::LichenNoise& noise);

/// Calls act(offset of the point, signed weight) for the impact that `word` encodes in the cube at
/// offset `way`, if the impact reaches the point.
template <class Act>
void actOnSurfaceImpact(std::uint32_t word, const Vec3& way, const SurfaceImpacts& surface,
                        const Act& act) {
  constexpr float kStep = 1.0f / 1024.0f; // 10 bits per axis, below the sign
  const std::array<std::uint32_t, 3> bits{word >> 21, word >> 11, word >> 1};
  Vec3 end{};
  for (std::size_t k = 0; k < 3; ++k)
    end[k] = way[k] + (float(bits[k] & 1023u) + 0.5f) * kStep;
  Vec3 place = surface.place;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& axis = surface.axes[k];
    place[k] -= end[0] * axis[0] + end[1] * axis[1] + end[2] * axis[2];
    if (!(std::abs(place[k]) < surface.radius[k]))
      return;
  }
  // [GLM17] section 6: the weight falls with the distance to the tangent plane.
  const float weight = 1.0f - std::abs(place[2]);
  act(Vec2{place[0], place[1]}, (word & 0x80000000u) != 0 ? -weight : weight);
}

/// Calls act(offset of the point, signed weight) for each impact that reaches the point, column by
/// column along z, in the order in which the shader sums them.
template <class Act>
void forEachSurfaceImpact(const SurfaceImpacts& surface, const shader::LichenMaterial& material,
                          const Act& act) {
  const auto cell = [&](std::size_t axis, int way) {
    return surface.cell[axis] + std::uint32_t(way);
  };
  for (int y = surface.first[1]; y <= surface.last[1]; ++y)
    for (int x = surface.first[0]; x <= surface.last[0]; ++x) {
      const std::array<std::uint32_t, 3> column =
          pcg3d({cell(0, x), cell(1, y), material.seedWord});
      for (int z = surface.first[2]; z <= surface.last[2]; ++z) {
        const Vec3 way{float(x), float(y), float(z)};
        const std::uint32_t word = pcg(column[0] + cell(2, z));
        if (textonPart(material).pointProcess != LICHEN_POINTS_POISSON) {
          actOnSurfaceImpact(word, way, surface, act);
          continue;
        }
        const auto count = std::uint32_t(poissonCount(pcg(column[1] + cell(2, z))));
        for (std::uint32_t k = 0; k < count; ++k)
          actOnSurfaceImpact(pcg(word + k), way, surface, act);
      }
    }
}

} // namespace lichen::texton
