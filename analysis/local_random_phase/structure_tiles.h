// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/structure.glsl.
#pragma once

#include "cosine_vertices.h"

#include <lichen/local_random_phase_map.h>
#include <lichen/tile_footprint.h>

#include <array>
#include <vector>

namespace lichen::local_random_phase {

/// The decoded structure of one map; adds nothing for a noise without structure.
class StructureTiles {
public:
  /// `image`: the floats of the map's image of cosines.
  StructureTiles(const CosineStructure& structure, const CosineImageLayout& layout,
                 const std::vector<float>& image, const LocalRandomPhaseMap& map,
                 const shader::LichenMap& constants);

  /// Columns and rows of level 0; 0 without a structure.
  [[nodiscard]] std::array<int, 2> size() const { return {structure_.columns, structure_.rows}; }

  /// What the structure adds, without contrast, to Gaussian values, and to twice the variance and
  /// what of it the footprint takes, in the sum over the channels.
  struct Value {
    std::array<float, 3> gaussian{};
    float squares = 0.0f, lost = 0.0f;
  };
  [[nodiscard]] Value at(const CosineCell& cell, const shader::LichenMaterial& material,
                         const TileFootprint& footprint) const;

private:
  using Vec2 = std::array<float, 2>;
  using Texels = std::vector<std::array<float, 3>>; ///< of a level, row by row; Gaussian values

  [[nodiscard]] std::array<float, 3> splineAt(const std::vector<Texels>& levels, int level,
                                              const Vec2& place) const;

  CosineStructure structure_;
  std::vector<Texels> levels_, means_; ///< means_: over the offsets
  std::vector<Vec2> offsets_;
  std::vector<float> deviations_; ///< as the shader has them, one more than levels
  float dimensions_ = 1.0f;
  float turbulence_ = 0.0f; ///< as the shader has it [tiles]
};

} // namespace lichen::local_random_phase
