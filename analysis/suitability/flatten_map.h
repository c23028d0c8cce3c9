// SPDX-License-Identifier: MIT
// Flattening of one map.
#pragma once

#include "low_pass.h"
#include "progress_part.h"

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// The light that was removed from a colour map, as shares of its mean; the mean over the channels.
struct LightRange {
  double darkest = 1.0;
  double brightest = 1.0;
};

/// Like flatten(), for one map with values in range and a period in its own pixels. Throws
/// Interrupted and std::bad_alloc.
LightRange flattenMap(MapExemplar& map, const Period& period, bool periodic, ProgressPart progress);

} // namespace lichen::suitability
