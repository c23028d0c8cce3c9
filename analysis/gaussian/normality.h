// SPDX-License-Identifier: MIT
// Tests whether an exemplar's stored values already are Gaussian.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::gaussian {

/// Returns the sliced Wasserstein-2 distance, in stored units, between a map's values and the
/// Gaussian with the same mean and covariance: the root mean square over fixed directions (1, 8, 16
/// for 1, 2, 3 channels). For one direction the square is the mean of (x - mean - deviation z)^2,
/// where z are the normal deviates in the order of x.
[[nodiscard]] double distanceToGaussian(const MapExemplar& map);

/// Returns whether the map needs no inverse table, because the distance is at most half a step of
/// 8 bits (docs/decisions/002-inverse-tables.md).
[[nodiscard]] bool isGaussian(const MapExemplar& map);

} // namespace lichen::gaussian
