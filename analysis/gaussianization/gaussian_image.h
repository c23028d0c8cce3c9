// SPDX-License-Identifier: MIT
// The Gaussian image of an exemplar that is already Gaussian: no transport, no inverse table.
#pragma once

#include "exemplar/color_space.h"
#include "gaussianize.h"
#include "progress_part.h"

namespace lichen::gaussianization {

/// G = 1/2 + A^-1 (x - mean) / 6, with A the lower Cholesky factor of the map's covariance, which
/// must be positive definite. If the borders do not fit they are then cross-faded. Mean 1/2 and
/// covariance I/36 are exact, even in 8 bits, where values beyond three standard deviations are
/// clamped. `matched` is empty.
[[nodiscard]] Gaussianized gaussianImage(const MapExemplar& map, gaussian::BorderTreatment borders,
                                         gaussian::Precision precision, ProgressPart progress = {});

} // namespace lichen::gaussianization
