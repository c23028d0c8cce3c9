// SPDX-License-Identifier: MIT
// Reads the member `grain` of tiling and quilting noises.
#pragma once

#include "object_reader.h"

#include <lichen/lattice.h>

namespace lichen {

/// Grain::none if the member is absent or not `x` or `y`, which is an error.
[[nodiscard]] Grain readGrain(ObjectReader& reader);

} // namespace lichen
