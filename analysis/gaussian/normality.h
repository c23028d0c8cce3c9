// SPDX-License-Identifier: MIT
// Tests whether an exemplar's stored values already are Gaussian.
#pragma once

#include "progress_part.h"

#include <lichen/exemplar.h>

namespace lichen::gaussian {

/// Returns the sliced Wasserstein-2 distance, in stored units, between a map's values and the
/// Gaussian with the same mean and covariance: the root mean square over fixed directions (1, 8, 16
/// for 1, 2, 3 channels). For one direction the square is the mean of (x - mean - deviation z)^2,
/// where z are the normal deviates in the order of x.
[[nodiscard]] double distanceToGaussian(const MapExemplar& map);

/// Returns whether the map needs no inverse table (docs/decisions/002-inverse-tables.md): either
/// the distance is below half a step of 8 bits, or it is below one step and no larger than chance
/// produces in Gaussian images of the same spectrum and size, at a level of 5 %.
[[nodiscard]] bool isGaussian(const MapExemplar& map, ProgressPart progress = {});

} // namespace lichen::gaussian
