// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a tiling noise and its tables.
#include "gaussian/gaussianized_maps.h"

#include <lichen/tiling.h>

#include <utility>

namespace lichen {
namespace {

/// As bakeTiling(), but throws std::bad_alloc.
Result<MethodBake> bakeMaps(const std::string& name, std::span<const MapExemplar> maps,
                            const TilingOptions& options) {
  MethodBake bake;
  bake.noise.name = name;
  const auto append = [&](gaussian::GaussianizedMap map) {
    TilingMap tiling;
    tiling.dimensions = map.image.dimensions;
    tiling.gaussian = gaussian::appended(std::move(map.gaussian), bake.tables);
    if (map.inverse)
      tiling.inverseTable = gaussian::appended(*std::move(map.inverse), bake.tables);
    map.map.data = tiling;
    bake.noise.maps.push_back(std::move(map.map));
  };
  const Result<gaussian::BorderTreatment> borders =
      gaussian::gaussianizeMaps(name, maps, options, gaussian::UsesGrain::yes, append);
  if (!borders)
    return borders.error();
  bake.noise.data = TilingNoise{borders.value().grain};
  bake.figures.bordersWereKept = borders.value().fit;
  return bake;
}

} // namespace

Result<MethodBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                              const TilingOptions& options) {
  return withinMemory([&] { return gaussian::noMemoryToBake(name, maps); },
                      [&] { return bakeMaps(name, maps, options); });
}

} // namespace lichen
