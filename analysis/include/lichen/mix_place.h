// SPDX-License-Identifier: MIT
// The position of a point between the steps of a mix.
#pragma once

#include <array>

namespace lichen {

/// The position of a point between the steps of a mix. Noises without a mix ignore it.
struct MixPlace {
  float weight = 0.0f;             ///< 0 is the first step, 1 the last; clamped
  std::array<float, 2> gradient{}; ///< its derivative, per tile
};

} // namespace lichen
