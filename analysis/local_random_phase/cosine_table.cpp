// SPDX-License-Identifier: MIT
// (cosines, vectors, structure) -> RGBA texels: one row for two cosines, then the structure.
#include "cosine_table.h"

#include <lichen/bfloat16_pair.h>
#include <lichen/lattice.h>
#include <lichen/local_random_phase_map.h>
#include <lichen/structure_texel.h>

#include <algorithm>
#include <cmath>

namespace lichen::local_random_phase {
namespace {

/// Writes the levels of a structure from the column `column` on. `largest`: per channel.
void setLevels(std::vector<float>& texels, const CosineImageLayout& layout, std::size_t column,
               const StructureImage& image, const std::array<double, 3>& largest) {
  for (std::size_t k = 0; k < image.levels.size(); ++k) {
    const StructureImage::Level& level = image.levels[k];
    const std::array<std::uint32_t, 2> corner = layout.levelCorner(int(k));
    for (int y = 0; y < level.rows; ++y)
      for (int x = 0; x < level.columns; ++x) {
        const auto& own =
            level.texels[std::size_t(y) * std::size_t(level.columns) + std::size_t(x)];
        std::array<int, 3> integers{};
        for (std::size_t c = 0; c < 3; ++c)
          if (largest[c] > 0.0)
            integers[c] = int(std::lround(kMostStructureInteger *
                                          std::clamp(double(own[c]) / largest[c], -1.0, 1.0)));
        const std::size_t texel = (corner[1] + std::size_t(y / 2)) * layout.width + corner[0] +
                                  column + std::size_t(x / 2);
        texels[4 * texel + std::size_t(2 * (y % 2) + x % 2)] = structureTexel(integers);
      }
  }
}

} // namespace

double MapStructure::largest(std::size_t channel) const {
  double result = 0.0;
  for (const StructureImage* part : {&image, &mean})
    for (const StructureImage::Level& level : part->levels)
      for (const std::array<float, 3>& texel : level.texels)
        result = std::max(result, std::abs(double(texel[channel])));
  return result;
}

std::vector<int> cosinesByOctave(const std::vector<Cosine>& cosines) {
  std::vector<int> counts;
  for (const Cosine& cosine : cosines) {
    if (counts.size() <= std::size_t(cosine.octave))
      counts.resize(std::size_t(cosine.octave) + 1, 0);
    ++counts[std::size_t(cosine.octave)];
  }
  return counts;
}

Table cosineTable(const LocalRandomPhaseNoise& shared, const std::vector<Cosine>& cosines,
                  const CosineVectors& vectors, const MapRows& rows,
                  const MapStructure& structure) {
  const CosineImageLayout layout(shared);
  Table table;
  table.format = TexelFormat::rgba32Sfloat;
  table.width = layout.width;
  table.height = layout.height;
  std::vector<float> texels(4 * std::size_t(table.width) * table.height);
  const auto set = [&](std::size_t j, std::size_t column, const CosineTexel& own) {
    const std::size_t texel = j / kRowCosines * table.width + column;
    float* pairs = &texels[4 * texel + 2 * (j % kRowCosines)];
    pairs[0] = bfloat16Pair(own[0], own[1]);
    pairs[1] = bfloat16Pair(own[2], own[3]);
  };
  for (std::size_t j = 0; j < cosines.size(); ++j) {
    const FrequencyBox& box = cosines[j].box;
    set(j, 0,
        {float(0.5 * (box.low() + box.high())), float(0.5 * (box.lowRow() + box.highRow())),
         float(box.width()), float(box.height())});
    // A vertex has one column of all its cosines, in which their signs should not agree.
    const auto first = std::size_t(pcg(std::uint32_t(j)) & std::uint32_t(vectors.variants - 1));
    for (std::size_t v = 0; v < std::size_t(vectors.variants); ++v) {
      CosineTexel variant{};
      for (std::size_t c = 0; c < rows.channels; ++c)
        variant[c] = float(vectors.vectors[j](Eigen::Index(rows.first + c), Eigen::Index(v)));
      variant[3] = float(vectors.phases[j](Eigen::Index(rows.map), Eigen::Index(v)));
      set(j, kCosineColumns + (v ^ first), variant);
    }
  }
  const std::array largest{structure.largest(0), structure.largest(1), structure.largest(2)};
  setLevels(texels, layout, 0, structure.image, largest);
  setLevels(texels, layout, layout.meanColumn, structure.mean, largest);
  float* list = texels.data() + 4 * std::size_t(layout.offsetRow) * layout.width;
  for (const std::array<double, 2>& offset : structure.offsets) {
    *list++ = float(offset[0]);
    *list++ = float(offset[1]);
  }
  appendTexels(table.texels, table.format, texels);
  return table;
}

} // namespace lichen::local_random_phase
