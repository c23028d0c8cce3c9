// SPDX-License-Identifier: MIT
// The impacts of a texton noise that reach a point: the CPU twin of
// shaders_glsl/noise/impacts.glsl, with the same roundings.
#pragma once

#include "sampling/poisson_count.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>

#include <array>
#include <cmath>

namespace lichen::texton {

using Vec2 = std::array<float, 2>;

/// The part of its frame that a texton covers when fetched at a level. [texels]
struct Reach {
  Vec2 low{};
  Vec2 high{};
};

/// A bilinear fetch is 0 from half a texel of the mip outside the coefficients on.
[[nodiscard]] Reach mipReach(float level, const shader::LichenTextonNoise& texton);

/// Values that all maps of a noise share at one point. Offsets are in texels, in the frame of an
/// impact's texton, relative to the centre of the area that the texton covers.
struct Impacts {
  float footprintLevel = 0.0f; ///< level of detail of the footprint, at least 0
  float level = 0.0f;          ///< the same, limited to the mips of the textons
  Vec2 middle{}, radius{};     ///< [texels] of the area that a texton covers at `level`
  std::array<std::uint32_t, 2> firstCell{}; ///< modulo the period
  Vec2 start{}, end{};                      ///< offsets of the point from corners of cells
  Vec2 cellTexels{};                        ///< sides of a cell [texels]
};

/// Finds the impacts whose textons reach the point, or come within `margin` texels of their mip.
[[nodiscard]] Impacts impactsWithin(float margin, const TileFootprint& at,
                                    const shader::LichenMaterial& material,
                                    const shader::LichenNoise& noise);

/// Returns the next cell along an axis, which is 0 after the last cell of the period.
[[nodiscard]] inline std::uint32_t nextCell(std::uint32_t cell, std::int32_t period) {
  return cell + 1 == std::uint32_t(period) ? 0 : cell + 1;
}

/// Calls act(offset of the point, sign) for the impact that `word` encodes in the cell with this
/// corner, if the impact reaches the point.
template <class Act>
void actOnImpact(std::uint32_t word, const Vec2& corner, const Impacts& impacts, const Act& act) {
  constexpr float kStep = 1.0f / 32768.0f; // 15 bits per axis, below the sign
  const auto along = [&](std::uint32_t bits, std::size_t axis) {
    return corner[axis] - (float(bits & 32767u) + 0.5f) * kStep * impacts.cellTexels[axis];
  };
  const Vec2 place{along(word >> 16, 0), along(word >> 1, 1)};
  if (std::abs(place[0]) < impacts.radius[0] && std::abs(place[1]) < impacts.radius[1])
    act(place, (word & 0x80000000u) != 0 ? -1.0f : 1.0f);
}

/// Calls act(offset of the point, sign) for each impact that reaches the point, row by row.
template <class Act>
void forEachImpact(const Impacts& impacts, const shader::LichenMaterial& material, const Act& act) {
  std::uint32_t j = impacts.firstCell[1];
  for (float y = impacts.start[1]; y > impacts.end[1]; y -= impacts.cellTexels[1]) {
    std::uint32_t i = impacts.firstCell[0];
    for (float x = impacts.start[0]; x >= impacts.end[0]; x -= impacts.cellTexels[0]) {
      const std::array<std::uint32_t, 3> hash = pcg3d({i, j, material.seedWord});
      if (textonPart(material).pointProcess == LICHEN_POINTS_POISSON) {
        const auto count = std::uint32_t(poissonCount(hash[1]));
        for (std::uint32_t k = 0; k < count; ++k)
          actOnImpact(pcg(hash[0] + k), {x, y}, impacts, act);
      } else {
        actOnImpact(hash[0], {x, y}, impacts, act);
      }
      i = nextCell(i, material.periodColumns);
    }
    j = nextCell(j, material.periodRows);
  }
}

} // namespace lichen::texton
