// SPDX-License-Identifier: MIT
// Which of a noise's maps has a target, the size of its exemplar, how it is decoded, and how a
// noise can be mapped.
#include <lichen/bundle.h>

#include <algorithm>

namespace lichen {

std::optional<std::size_t> findMap(const Noise& noise, MapTarget target) {
  const auto found = std::find_if(noise.maps.begin(), noise.maps.end(),
                                  [&](const NoiseMap& map) { return map.target == target; });
  if (found == noise.maps.end())
    return std::nullopt;
  return std::size_t(found - noise.maps.begin());
}

std::array<std::uint32_t, 2> exemplarSize(const Bundle& bundle, const Noise& noise,
                                          const NoiseMap& map) {
  if (noise.method == Method::texton)
    return {std::uint32_t(noise.texton.texelsPerTileX), std::uint32_t(noise.texton.texelsPerTileY)};
  const Table& gaussian = bundle.tables[map.image];
  return {gaussian.width, gaussian.height};
}

bool mappingFits(Method method, Mapping mapping) {
  switch (mapping) {
  case Mapping::surface:
    return method == Method::texton;
  case Mapping::solid:
    return false; // of the methods that the format has
  default:
    return true;
  }
}

bool isInSpace(Mapping mapping) { return mapping != Mapping::uv; }

std::span<const double> lossRow(std::span<const double> mipLoss, std::size_t row,
                                std::size_t rows) {
  const std::size_t levels = mipLoss.size() / rows;
  return mipLoss.subspan(row * levels, levels);
}

TableKind tableKindOf(const NoiseMap& map) {
  if (!map.inverseTable)
    return TableKind::none;
  return map.tableOffset.empty() ? TableKind::joint : TableKind::separable;
}

std::string_view nameOf(TableKind kind) {
  constexpr std::array<std::string_view, 3> kNames = {"joint", "separable", "none"};
  return kNames[std::size_t(kind)];
}

} // namespace lichen
