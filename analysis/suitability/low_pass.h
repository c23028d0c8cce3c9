// SPDX-License-Identifier: MIT
// Low-pass filter of one plane.
#pragma once

#include <vector>

namespace lichen::suitability {

/// One channel of an image.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values; ///< width * height, row-major
};

/// A period along each axis, in pixels.
struct Period {
  double x = 0.0;
  double y = 0.0;
};

/// The plane and its mirror images, 2 width x 2 height: periodic, and continuous at the borders.
[[nodiscard]] Plane mirrored(const Plane& plane);

/// `trend`, and what lowPassGain() leaves of the rest of the plane, which repeats beyond the
/// borders if `periodic` and is mirrored otherwise. Without trendOf(), a mirrored ramp would have a
/// crease that no filter follows. Throws std::bad_alloc.
[[nodiscard]] Plane lowPassed(const Plane& plane, Plane trend, const Period& period, bool periodic);

} // namespace lichen::suitability
