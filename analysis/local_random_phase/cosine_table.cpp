// SPDX-License-Identifier: MIT
// (cosines, vectors) -> RGBA texels, one row for two cosines.
#include "cosine_table.h"

#include <lichen/bfloat16_pair.h>
#include <lichen/lattice.h>
#include <lichen/local_random_phase_map.h>

namespace lichen::local_random_phase {

std::vector<int> cosinesByOctave(const std::vector<Cosine>& cosines) {
  std::vector<int> counts;
  for (const Cosine& cosine : cosines) {
    if (counts.size() <= std::size_t(cosine.octave))
      counts.resize(std::size_t(cosine.octave) + 1, 0);
    ++counts[std::size_t(cosine.octave)];
  }
  return counts;
}

Table cosineTable(const std::vector<Cosine>& cosines, const CosineVectors& vectors,
                  const MapRows& rows) {
  Table table;
  table.format = TexelFormat::rgba32Sfloat;
  table.width = kCosineColumns + std::uint32_t(vectors.variants);
  table.height = std::uint32_t(cosines.size()) / kRowCosines;
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
  appendTexels(table.texels, table.format, texels);
  return table;
}

} // namespace lichen::local_random_phase
