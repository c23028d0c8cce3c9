// SPDX-License-Identifier: MIT
// A map's constants at one weight of a mix: the CPU twin of shaders_glsl/noise/texton_mix.glsl.
#pragma once

#include <lichen/bundle.h>
#include <lichen/shader_parameters.h>
#include <lichen/texton_evaluate.h>

#include <array>
#include <vector>

namespace lichen::texton {

/// The table of a mix as the shader's sampler reads it. Immutable.
class MixRows {
public:
  /// For a map without a mix it stores nothing. Throws std::bad_alloc.
  explicit MixRows(const NoiseMap& map);

  /// Returns the map at this weight of the mix; without a mix, returns `map` unchanged.
  [[nodiscard]] shader::LichenMap at(shader::LichenMap map, const MixPlace& mix) const;

  /// Returns the derivative of the first channel's mean along x and y, per tile.
  [[nodiscard]] std::array<float, 2> meanSlope(const MixPlace& mix) const;

private:
  using Row = std::array<float, 4>;
  [[nodiscard]] Row row(float atStep, std::size_t index) const;
  [[nodiscard]] float stepOf(const MixPlace& mix) const;

  std::size_t steps_ = 0;
  std::vector<float> values_; ///< rows x steps x 4
};

} // namespace lichen::texton
