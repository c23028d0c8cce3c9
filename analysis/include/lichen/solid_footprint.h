// SPDX-License-Identifier: MIT
// The footprint at which a noise is evaluated in space.
#pragma once

#include <array>

namespace lichen {

/// A point in space and the footprint of one pixel there. All values are finite.
struct SolidFootprint {
  /// Metres from the tile origin in LichenNoise, below 2^27 tiles in magnitude.
  std::array<float, 3> position{};
  std::array<float, 3> dx{}; ///< derivative along the result's x, metres per pixel
  std::array<float, 3> dy{}; ///< the same along y; dx = dy = 0 is a point
};

} // namespace lichen
