// SPDX-License-Identifier: MIT
// The footprint at which a noise is evaluated on a surface.
#pragma once

#include <array>

namespace lichen {

/// A point on a surface and the footprint of one pixel there. All values are finite.
struct SurfaceFootprint {
  /// Metres from the tile origin in LichenNoise, below 2^28 tiles in magnitude.
  std::array<float, 3> position{};
  std::array<float, 3> dx{};      ///< derivative along the result's x, metres per pixel
  std::array<float, 3> dy{};      ///< the same along y
  std::array<float, 3> normal{};  ///< not 0, any length
  std::array<float, 4> tangent{}; ///< as in glTF: any length, w is the sign of the bitangent
};

} // namespace lichen
