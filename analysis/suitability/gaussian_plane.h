// SPDX-License-Identifier: MIT
// The plane that random blending blends, in one channel and without the bake's transport.
#pragma once

#include "gaussian/cross_fade.h"
#include "progress_part.h"

#include <lichen/exemplar.h>

#include <optional>
#include <vector>

namespace lichen::suitability {

/// width * height values of mean 0 and variance 1, row-major, periodic.
struct GaussianPlane {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// The principal component of the map, Gaussianized by rank. Borders that do not fit are
/// cross-faded as in the bake of a noise with this grain. Nothing if the map varies by no more than
/// its rounding. Throws std::bad_alloc.
[[nodiscard]] std::optional<GaussianPlane> gaussianPlane(const MapExemplar& map,
                                                         gaussian::BorderTreatment borders,
                                                         ProgressPart progress = {});

} // namespace lichen::suitability
