// SPDX-License-Identifier: MIT
// Makes a Gaussian image periodic when its borders do not match.
#pragma once

#include "transport/point.h"

#include <lichen/lattice.h>

#include <vector>

namespace lichen::gaussian {

/// What the borders of an image are like.
struct Borders {
  bool fit = true;
  Grain grain = Grain::none; ///< of what is faded if they do not fit
};

/// Cross-fades a band of an eighth of the side along each border pair with the image displaced by
/// half its size, which is continuous there. The blend preserves the variance of independent
/// values: mean + (a (g - mean) + b (h - mean)) / sqrt(a^2 + b^2), [HN18] eq. 8.
///
/// With a grain, the streaks, which are the image averaged along it, have a band of half the side
/// at the borders that they cross, so that they end there at different places; docs/decisions/
/// 036-grain.md. Their variance is preserved for values that correlate as the halves of the streaks
/// do.
[[nodiscard]] std::vector<Point> crossFadeBorders(const std::vector<Point>& image, int width,
                                                  int height, Grain grain = Grain::none);

} // namespace lichen::gaussian
