// SPDX-License-Identifier: MIT
// The plane that random blending blends, in one channel and without the bake's transport.
#pragma once

#include "exemplar/planes.h"
#include "gaussian/cross_fade.h"
#include "progress_part.h"

#include <lichen/exemplar.h>

#include <optional>

namespace lichen::suitability {

/// Values of mean 0 and variance 1, periodic.
using GaussianPlane = exemplar::Plane;

/// The principal component of the map, Gaussianized by rank. Borders that do not fit are
/// cross-faded as in the bake of a noise with this grain. Nothing if the map varies by no more than
/// its rounding. Throws std::bad_alloc.
[[nodiscard]] std::optional<GaussianPlane> gaussianPlane(const MapExemplar& map,
                                                         gaussian::BorderTreatment borders,
                                                         ProgressPart progress = {});

} // namespace lichen::suitability
