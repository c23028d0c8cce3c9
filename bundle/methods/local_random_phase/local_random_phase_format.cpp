// SPDX-License-Identifier: MIT
// The supported mappings of local random-phase noise, the size of its exemplar, and its members as
// JSON.
#include "local_random_phase_format.h"

#include <lichen/bfloat16_pair.h>

#include <algorithm>
#include <bit>
#include <numeric>

namespace lichen {

using Json = nlohmann::ordered_json;

namespace {

std::string_view structureObstacle(bool hasStructure, Mapping mapping) {
  return mapping == Mapping::solid && hasStructure ? "it has a structure, which lies in a plane"
                                                   : "";
}

} // namespace

bool LocalRandomPhaseFormat::fits(Mapping mapping) const { return mapping != Mapping::surface; }

std::string_view LocalRandomPhaseFormat::obstacle(const Noise& noise, Mapping mapping) const {
  return structureObstacle(noise.as<LocalRandomPhaseNoise>().structure.columns != 0, mapping);
}

std::string_view LocalRandomPhaseFormat::obstacle(const shader::LichenNoise& noise,
                                                  Mapping mapping) const {
  return structureObstacle(cosinesPart(noise).structure != 0, mapping);
}

std::span<const std::string_view> LocalRandomPhaseFormat::tableMembers() const {
  static constexpr std::array<std::string_view, 2> kMembers{"cosines", "inverseTable"};
  return kMembers;
}

void LocalRandomPhaseFormat::writeNoise(const Noise& noise, Json& json) const {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  json["localRandomPhase"] = {{"texelsPerTile", {shared.texelsPerTileX, shared.texelsPerTileY}},
                              {"columns", shared.columns},
                              {"rows", shared.rows},
                              {"octaves", shared.cosines},
                              {"variants", shared.variants}};
  if (shared.hasGivenSpectrum)
    json["localRandomPhase"]["spectrum"] = "given";
  const CosineStructure& structure = shared.structure;
  if (structure.columns == 0)
    return;
  Json& own = json["localRandomPhase"]["structure"];
  own["texels"] = {structure.columns, structure.rows};
  if (structure.offsets > 0)
    own["offsets"] = structure.offsets;
  if (structure.turbulence > 0.0)
    own["turbulence"] = structure.turbulence;
}

void LocalRandomPhaseFormat::writeMap(const NoiseMap& map, Json& json) const {
  const auto& own = map.as<LocalRandomPhaseMap>();
  json["dimensions"] = own.dimensions;
  json["cosines"] = own.cosines;
  if (!own.structureAmplitudes.empty())
    json["structure"] = {{"amplitudes", own.structureAmplitudes},
                         {"deviations", own.structureDeviations}};
  if (own.inverseTable)
    json["inverseTable"] = *own.inverseTable;
}

std::array<std::uint32_t, 2> LocalRandomPhaseFormat::exemplarSize(const Bundle& bundle,
                                                                  const Noise& noise,
                                                                  const NoiseMap&) const {
  return tileSize(bundle, noise);
}

std::array<std::uint32_t, 2> LocalRandomPhaseFormat::tileSize(const Bundle&,
                                                              const Noise& noise) const {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  return {std::uint32_t(shared.texelsPerTileX), std::uint32_t(shared.texelsPerTileY)};
}

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
