// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a tiling noise and its tables.
#include "gaussianization/gaussianized_maps.h"

#include <lichen/tiling.h>

#include <utility>

namespace lichen {
namespace {

std::size_t appended(Table table, std::vector<Table>& tables) {
  tables.push_back(std::move(table));
  return tables.size() - 1;
}

/// As bakeTiling(), but throws std::bad_alloc.
Result<TilingBake> bakeMaps(const std::string& name, std::span<const MapExemplar> maps,
                            const TilingOptions& options) {
  TilingBake bake;
  bake.noise.name = name;
  const auto append = [&](gaussianization::GaussianizedMap map) {
    TilingMap tiling;
    tiling.dimensions = map.image.dimensions;
    tiling.gaussian = appended(std::move(map.gaussian), bake.tables);
    if (map.inverse)
      tiling.inverseTable = appended(*std::move(map.inverse), bake.tables);
    map.map.data = tiling;
    bake.noise.maps.push_back(std::move(map.map));
  };
  const Result<gaussian::BorderTreatment> borders = gaussianization::gaussianizeMaps(
      name, maps, options, gaussianization::UsesGrain::yes, append);
  if (!borders)
    return borders.error();
  bake.noise.data = TilingNoise{borders.value().grain};
  bake.exemplarWasPeriodic = borders.value().fit;
  return bake;
}

} // namespace

Result<TilingBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                              const TilingOptions& options) {
  return withinMemory([&] { return gaussianization::noMemoryToBake(name, maps); },
                      [&] { return bakeMaps(name, maps, options); });
}

} // namespace lichen
