// SPDX-License-Identifier: MIT
// `lichen apply`: what one tile of the noise measures on each material.
#pragma once

#include "command.h"

#include <lichen/gltf_scene.h>
#include <lichen/tile_size.h>

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// The tile of one material that could be measured.
struct MaterialTile {
  std::string material; ///< its title
  std::string object;   ///< "node 'house'", or "its 12 nodes"
  TileSize size;
};

/// Measures the tiles. Adds notes on materials that cannot be measured, and on those whose tile is
/// too large or too small in the typical view, with a --scale that mends the first of them.
[[nodiscard]] std::vector<MaterialTile> measuredTiles(GltfScene& scene,
                                                      std::span<const std::size_t> materials,
                                                      const Noise& noise, const MaterialNoise& use,
                                                      std::vector<std::string>& notes);

/// One line per material, for the first few.
[[nodiscard]] std::vector<std::string> linesOn(std::span<const MaterialTile> tiles);

[[nodiscard]] nlohmann::ordered_json asJson(std::span<const MaterialTile> tiles);

} // namespace lichen::cli
