// SPDX-License-Identifier: MIT
// The impacts of a texton noise that reach a point: the CPU twin of
// shaders_glsl/noise/impacts.glsl, with the same roundings.
#pragma once

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>

#include <array>
#include <cmath>

namespace lichen::texton {

using Vec2 = std::array<float, 2>;

/// What a texton reaches of its frame, fetched at a level. [texels]
struct Reach {
  Vec2 low{};
  Vec2 high{};
};

/// Half a texel of the mip outside the coefficients, a bilinear fetch is 0.
[[nodiscard]] Reach mipReach(float level, const shader::LichenTexton& texton);

/// What all maps of a noise share at one point. A place is [texels], in the frame of an impact's
/// texton, from the middle of what it reaches.
struct Impacts {
  float footprintLevel = 0.0f; ///< of the mip that shows what the footprint does, at least 0
  float level = 0.0f;          ///< likewise, as far as the textons have mips
  Vec2 middle{}, radius{};     ///< [texels] of what a texton reaches, fetched at this level
  std::array<std::uint32_t, 2> firstCell{}; ///< in the period
  Vec2 start{}, end{};                      ///< places seen from corners of cells
  Vec2 cellTexels{};                        ///< sides of a cell
};

/// Impacts whose textons reach a point, or reach `margin` texels of their mip beyond.
[[nodiscard]] Impacts impactsWithin(float margin, const TileFootprint& at,
                                    const shader::LichenNoise& noise,
                                    const shader::LichenTexton& texton);

/// Impacts in a cell of the Poisson process: the quantile of a Poisson variable of mean 1 at
/// hash / 2^32.
[[nodiscard]] int poissonCount(std::uint32_t hash);

/// The cell after another along an axis; the first one after the last of the period.
[[nodiscard]] inline std::uint32_t nextCell(std::uint32_t cell, std::int32_t period) {
  return cell + 1 == std::uint32_t(period) ? 0 : cell + 1;
}

/// act(place of the point, sign) for the impact of this word in the cell with this corner, if it
/// reaches the point.
template <class Act>
void actOnImpact(std::uint32_t word, const Vec2& corner, const Impacts& impacts, const Act& act) {
  constexpr float kStep = 1.0f / 32768.0f; // 15 bits an axis, below the sign
  const auto along = [&](std::uint32_t bits, std::size_t axis) {
    return corner[axis] - (float(bits & 32767u) + 0.5f) * kStep * impacts.cellTexels[axis];
  };
  const Vec2 place{along(word >> 16, 0), along(word >> 1, 1)};
  if (std::abs(place[0]) < impacts.radius[0] && std::abs(place[1]) < impacts.radius[1])
    act(place, (word & 0x80000000u) != 0 ? -1.0f : 1.0f);
}

/// act(place of the point, sign) for each impact that reaches it, row by row.
template <class Act>
void forEachImpact(const Impacts& impacts, const shader::LichenNoise& noise,
                   const shader::LichenTexton& texton, const Act& act) {
  std::uint32_t j = impacts.firstCell[1];
  for (float y = impacts.start[1]; y > impacts.end[1]; y -= impacts.cellTexels[1]) {
    std::uint32_t i = impacts.firstCell[0];
    for (float x = impacts.start[0]; x >= impacts.end[0]; x -= impacts.cellTexels[0]) {
      const std::array<std::uint32_t, 3> hash = pcg3d({i, j, noise.seedWord});
      if (texton.pointProcess == LICHEN_POINTS_POISSON) {
        const auto count = std::uint32_t(poissonCount(hash[1]));
        for (std::uint32_t k = 0; k < count; ++k)
          actOnImpact(pcg(hash[0] + k), {x, y}, impacts, act);
      } else {
        actOnImpact(hash[0], {x, y}, impacts, act);
      }
      i = nextCell(i, noise.periodColumns);
    }
    j = nextCell(j, noise.periodRows);
  }
}

} // namespace lichen::texton
