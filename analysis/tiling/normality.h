// SPDX-License-Identifier: MIT
// Whether an exemplar's stored values are Gaussian already.
#pragma once

#include <lichen/tiling.h>

namespace lichen::tiling {

/// Sliced Wasserstein-2 distance, in stored units, between a map's values and the Gaussian of the
/// same mean and covariance: the root mean square over fixed directions (1, 8, 16 for 1, 2, 3
/// channels). Of one direction, sum over ranks i of (x_i - mean - deviation q((i + 1/2) / N))^2 /
/// N.
[[nodiscard]] double distanceToGaussian(const MapExemplar& map);

/// Whether the map may do without an inverse table (docs/decisions/011-gaussian-only.md): the
/// distance is below half a step of 8 bits, or it is below one step and no larger than chance
/// makes it in Gaussian images of the same spectrum and size, at a level of 5 %.
[[nodiscard]] bool isGaussian(const MapExemplar& map);

} // namespace lichen::tiling
