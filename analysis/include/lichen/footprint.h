// SPDX-License-Identifier: MIT
// Where a noise is evaluated: a position, and the footprint of one pixel there. All values are
// finite; derivatives are along the result's x (dx) and y (dy), and dx = dy = 0 is a point.
#pragma once

#include <array>
#include <variant>

namespace lichen {

/// On the plane of tiles.
struct TileFootprint {
  /// Tiles from the tile origin of the placement, without the material's offset, below 2^28 in
  /// magnitude. Floats resolve it to 2^-24 of its magnitude, so exact texels of a 256-texel tile
  /// need a magnitude below 2^15.
  std::array<float, 2> position{};
  std::array<float, 2> dx{}; ///< tiles per pixel
  std::array<float, 2> dy{};
};

/// On a surface that shows three planes.
struct TriplanarFootprint {
  /// Metres from the tile origin of the placement, below 2^28 tiles in magnitude.
  std::array<float, 3> position{};
  std::array<float, 3> dx{}; ///< metres per pixel
  std::array<float, 3> dy{};
  std::array<float, 3> normal{}; ///< not 0, any length; may point to either side
};

/// On a surface that carries impacts.
struct SurfaceFootprint {
  std::array<float, 3> position{}; ///< as TriplanarFootprint::position
  std::array<float, 3> dx{};
  std::array<float, 3> dy{};
  std::array<float, 3> normal{};  ///< not 0, any length
  std::array<float, 4> tangent{}; ///< as in glTF: any length, w is the sign of the bitangent
};

/// In a solid.
struct SolidFootprint {
  std::array<float, 3> position{}; ///< as TriplanarFootprint::position, below 2^27 tiles
  std::array<float, 3> dx{};
  std::array<float, 3> dy{};
};

/// One kind for each mapping.
using Footprint = std::variant<TileFootprint, TriplanarFootprint, SurfaceFootprint, SolidFootprint>;

/// The position of a point between the steps of a mix. Noises without a mix ignore it.
struct MixPlace {
  float weight = 0.0f;             ///< 0 is the first step, 1 the last; clamped
  std::array<float, 2> gradient{}; ///< its derivative, per tile
};

} // namespace lichen
