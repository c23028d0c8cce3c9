// SPDX-License-Identifier: MIT
// Low-discrepancy points for averaging frames.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace lichen::renderer {

/// Point i of a sequence in [0, 1)^2 whose every contiguous part is well distributed: multiples of
/// the inverse powers of the plastic number [Roberts 2018, "The Unreasonable Effectiveness of
/// Quasirandom Sequences", R2]. Point 0 is the centre.
[[nodiscard]] inline glm::vec2 spreadPoint(std::uint32_t i) {
  constexpr double kPlastic = 1.32471795724474602596;
  const glm::dvec2 steps(1.0 / kPlastic, 1.0 / (kPlastic * kPlastic));
  return glm::vec2(glm::fract(0.5 + double(i) * steps));
}

/// The same point mapped to the unit disc: radius from x, azimuth from y.
[[nodiscard]] inline glm::vec2 spreadOnDisc(std::uint32_t i) {
  const glm::vec2 p = spreadPoint(i);
  const float azimuth = 6.28318530718f * p.y;
  return glm::sqrt(p.x) * glm::vec2(glm::cos(azimuth), glm::sin(azimuth));
}

} // namespace lichen::renderer
