// SPDX-License-Identifier: MIT
// The Gaussian image of an exemplar that is Gaussian already: no transport, and no inverse table.
#pragma once

#include "exemplar/color_space.h"
#include "gaussianize.h"
#include "progress_part.h"

namespace lichen::tiling {

/// G = 1/2 + A^-1 (x - mean) / 6, A the lower Cholesky factor of the map's covariance, positive
/// definite. If `periodic` is false the borders are then cross-faded. Mean 1/2 and covariance I/36
/// are exact, in 8 bits too, where values beyond three deviations are clamped. `matched` is empty.
[[nodiscard]] Gaussianized gaussianImage(const MapExemplar& map, const exemplar::Moments& moments,
                                         bool periodic, gaussian::Precision precision,
                                         ProgressPart progress = {});

} // namespace lichen::tiling
