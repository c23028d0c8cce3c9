// SPDX-License-Identifier: MIT
// Whether an exemplar tiles, and what makes it tile if it does not.
#pragma once

#include "transport/point.h"

#include <lichen/tiling.h>

#include <vector>

namespace lichen::tiling {

/// Whether the values on opposite borders differ no more than neighbours inside do: the mean
/// absolute difference across each seam against the distribution of the same mean over all the
/// interior rows and columns. Sides under 8 pixels count as periodic: there is no interior to
/// compare with.
[[nodiscard]] bool isPeriodic(const MapExemplar& map);

/// Makes a Gaussian image periodic: a band of an eighth of the side along each border pair is
/// cross-faded with the image displaced by half its size, which is continuous there. The blend
/// preserves the variance of independent values: mean + (a (g - mean) + b (h - mean)) /
/// sqrt(a^2 + b^2), [HN18] eq. 8.
[[nodiscard]] std::vector<Point> crossFadeBorders(const std::vector<Point>& image, int width,
                                                  int height);

} // namespace lichen::tiling
