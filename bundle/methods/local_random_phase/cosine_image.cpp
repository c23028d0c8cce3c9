// SPDX-License-Identifier: MIT
// Where the cosines and the levels of a structure lie in their image.
#include <lichen/bfloat16_pair.h>
#include <lichen/local_random_phase_map.h>

#include <algorithm>
#include <bit>
#include <numeric>

namespace lichen {

int structureLevels(const CosineStructure& structure) {
  return int(std::bit_width(unsigned(std::min(structure.columns, structure.rows)) / 2u));
}

CosineImageLayout::CosineImageLayout(const LocalRandomPhaseNoise& shared)
    : cosineColumns(kCosineColumns + std::uint32_t(shared.variants)),
      cosineRows(std::uint32_t(shared.cosineCount()) / kRowCosines), offsetRow(cosineRows),
      meanColumn(std::uint32_t(shared.structure.columns) / 2u),
      structureColumns_(std::uint32_t(shared.structure.columns)),
      structureRows_(std::uint32_t(shared.structure.rows)) {
  const bool hasMean = shared.structure.offsets > 0;
  firstLevelRow_ = offsetRow + (hasMean ? 1u : 0u);
  width = std::max(cosineColumns, hasMean ? 2u * meanColumn : meanColumn);
  height = firstLevelRow_ + structureRows_ / 2u + structureRows_ / 4u;
}

std::array<std::uint32_t, 2> CosineImageLayout::levelCorner(int level) const {
  if (level == 0)
    return {0, firstLevelRow_};
  return {structureColumns_ / 2u - (structureColumns_ >> level),
          firstLevelRow_ + structureRows_ / 2u};
}

std::vector<std::array<CosineTexel, kRowCosines>> cosineTexels(const std::vector<float>& image,
                                                               const CosineImageLayout& layout) {
  std::vector<std::array<CosineTexel, kRowCosines>> texels;
  texels.reserve(std::size_t(layout.cosineColumns) * layout.cosineRows);
  for (std::size_t row = 0; row < layout.cosineRows; ++row)
    for (std::size_t column = 0; column < layout.cosineColumns; ++column) {
      const float* texel = &image[4 * (row * layout.width + column)];
      auto& cosines = texels.emplace_back();
      for (std::size_t j = 0; j < kRowCosines; ++j) {
        const auto [first, second] = fromBfloat16Pair(texel[2 * j]);
        const auto [third, fourth] = fromBfloat16Pair(texel[2 * j + 1]);
        cosines[j] = {first, second, third, fourth};
      }
    }
  return texels;
}

int LocalRandomPhaseNoise::cosineCount() const {
  return std::accumulate(cosines.begin(), cosines.end(), 0);
}

} // namespace lichen
