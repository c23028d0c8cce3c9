// SPDX-License-Identifier: MIT
// What a bake does at the borders of an exemplar.
#pragma once

#include <lichen/lattice.h>

namespace lichen::gaussian {

/// Whether opposite borders match, and along which axis streaks fade if they do not.
struct BorderTreatment {
  bool fit = true;
  Grain grain = Grain::none;
};

} // namespace lichen::gaussian
