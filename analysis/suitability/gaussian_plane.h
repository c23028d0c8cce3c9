// SPDX-License-Identifier: MIT
// What random blending will blend, in one channel and without the bake's transport.
#pragma once

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

/// The map projected on the eigenvector of its covariance with the largest eigenvalue: one channel.
/// Throws std::bad_alloc.
[[nodiscard]] MapExemplar principalComponent(const MapExemplar& map);

/// The map along the principal axis of its values, where it varies most, Gaussianized by rank; if
/// not `periodic`, with its borders cross-faded as the bake does. Nothing for a map that varies by
/// no more than its rounding. Throws std::bad_alloc.
[[nodiscard]] std::optional<GaussianPlane> gaussianPlane(const MapExemplar& map, bool periodic,
                                                         ProgressPart progress = {});

} // namespace lichen::suitability
