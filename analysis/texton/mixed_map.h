// SPDX-License-Identifier: MIT
// A map's constants at a place of a mix: the CPU twin of shaders_glsl/noise/texton_mix.glsl.
#pragma once

#include <lichen/bundle.h>
#include <lichen/shader_parameters.h>
#include <lichen/texton_evaluate.h>

#include <array>
#include <vector>

namespace lichen::texton {

/// The table of a mix, as the shader's sampler sees it. Immutable.
class MixRows {
public:
  /// Of a map without a mix, nothing. Throws std::bad_alloc.
  explicit MixRows(const NoiseMap& map);

  /// The map at its place in a mix; without a mix, as it is.
  [[nodiscard]] shader::LichenMap at(shader::LichenMap map, const MixPlace& mix) const;

  /// The derivative of the mean of the first channel along x and y, per tile.
  [[nodiscard]] std::array<float, 2> meanSlope(const MixPlace& mix) const;

private:
  using Row = std::array<float, 4>;
  [[nodiscard]] Row row(float atStep, std::size_t index) const;
  [[nodiscard]] float stepOf(const MixPlace& mix) const;

  std::size_t steps_ = 0;
  std::vector<float> values_; ///< rows of steps of four
};

} // namespace lichen::texton
