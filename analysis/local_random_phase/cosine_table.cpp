// SPDX-License-Identifier: MIT
// (cosines, vectors) -> RGBA texels, one row for each cosine.
#include "cosine_table.h"

#include <lichen/local_random_phase_map.h>

#include <array>

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
                  const MapRows& rows, int bits) {
  Table table;
  table.format = bits == 8 ? TexelFormat::rgba16Sfloat : TexelFormat::rgba32Sfloat;
  table.width = kCosineColumns + std::uint32_t(vectors.variants);
  table.height = std::uint32_t(cosines.size());
  std::vector<float> texels;
  for (std::size_t j = 0; j < cosines.size(); ++j) {
    const FrequencyBox& box = cosines[j].box;
    const double stepX = box.width() / kFrequencySteps, stepY = box.height() / kFrequencySteps;
    // The middle of the first step.
    const std::array<double, 4> frequency{box.low() + 0.5 * stepX, box.lowRow() + 0.5 * stepY,
                                          stepX, stepY};
    texels.insert(texels.end(), frequency.begin(), frequency.end());
    std::vector<std::array<double, 4>> variants(std::size_t(vectors.variants));
    for (std::size_t v = 0; v < variants.size(); ++v) {
      for (std::size_t c = 0; c < rows.channels; ++c) {
        const double amplitude = vectors.vectors[j](Eigen::Index(rows.first + c), Eigen::Index(v));
        variants[v][c] = amplitude;
      }
      variants[v][3] = vectors.phases[j](Eigen::Index(rows.map), Eigen::Index(v));
    }
    for (const std::array<double, 4>& variant : variants)
      texels.insert(texels.end(), variant.begin(), variant.end());
  }
  appendTexels(table.texels, table.format, texels);
  return table;
}

} // namespace lichen::local_random_phase
