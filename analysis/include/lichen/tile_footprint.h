// SPDX-License-Identifier: MIT
// The footprint at which a noise is evaluated on the CPU.
#pragma once

#include <array>

namespace lichen {

/// A position in tile space and the footprint of one pixel there. All values are finite.
struct TileFootprint {
  /// Tiles from the tile origin of the placement, without the material's offset, below 2^28 in
  /// magnitude. Floats resolve it to 2^-24 of its magnitude, so exact texels of a 256-texel tile
  /// need a magnitude below 2^15.
  std::array<float, 2> position{};
  std::array<float, 2> dx{}; ///< derivative along the result's x, tiles per pixel; 0 is a point
  std::array<float, 2> dy{}; ///< the same along y
};

} // namespace lichen
