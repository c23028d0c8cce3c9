// SPDX-License-Identifier: MIT
// Whether an exemplar's stored values are Gaussian already.
#pragma once

#include "progress_part.h"

#include <lichen/exemplar.h>

namespace lichen::gaussian {

/// Sliced Wasserstein-2 distance, in stored units, between a map's values and the Gaussian of the
/// same mean and covariance: the root mean square over fixed directions (1, 8, 16 for 1, 2, 3
/// channels). Of one direction, the mean of (x - mean - deviation z)^2, z the normal deviates in
/// the order of x.
[[nodiscard]] double distanceToGaussian(const MapExemplar& map);

/// Whether the map may do without an inverse table (docs/decisions/011-gaussian-only.md): the
/// distance is below half a step of 8 bits, or it is below one step and no larger than chance
/// makes it in Gaussian images of the same spectrum and size, at a level of 5 %.
[[nodiscard]] bool isGaussian(const MapExemplar& map, ProgressPart progress = {});

} // namespace lichen::gaussian
