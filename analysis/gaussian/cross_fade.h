// SPDX-License-Identifier: MIT
// Makes a Gaussian image periodic when its borders do not match.
#pragma once

#include "transport/point.h"

#include <lichen/lattice.h>

#include <vector>

namespace lichen::gaussian {

/// Cross-fades a band of an eighth of the side along each border pair with the image displaced by
/// half its size, which is continuous there. The blend preserves the variance of independent
/// values: mean + (a (g - mean) + b (h - mean)) / sqrt(a^2 + b^2), [HN18] eq. 8.
///
/// With a grain, the image's average along it, which holds the streaks, has a band of half the side
/// at the borders that the streaks cross. Each streak then ends at another point:
/// docs/decisions/006-light-and-grain.md. The blend preserves the variance of streaks whose halves
/// correlate as in this image.
[[nodiscard]] std::vector<Point> crossFadeBorders(const std::vector<Point>& image, int width,
                                                  int height, Grain grain = Grain::none);

/// Whether opposite borders match, and along which axis streaks fade if they do not.
struct BorderTreatment {
  bool fit = true;
  Grain grain = Grain::none;
};

} // namespace lichen::gaussian
