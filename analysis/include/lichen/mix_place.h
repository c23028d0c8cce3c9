// SPDX-License-Identifier: MIT
// Where a point lies in a mix.
#pragma once

#include <array>

namespace lichen {

/// Between which steps of a mix a point lies; ignored by noises that are no mix.
struct MixPlace {
  float weight = 0.0f;             ///< 0 is the first step, 1 the last; clamped
  std::array<float, 2> gradient{}; ///< its derivative, per tile
};

} // namespace lichen
