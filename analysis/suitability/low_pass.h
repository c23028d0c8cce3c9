// SPDX-License-Identifier: MIT
// Planes without their fast variation.
#pragma once

#include <vector>

namespace lichen::suitability {

/// One channel of an image.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values; ///< width * height, row-major
};

/// A period along each axis, pixels.
struct Period {
  double x = 0.0;
  double y = 0.0;
};

/// The plane by lowPassGain(); continued at the borders by itself if `periodic`, else by its mirror
/// image. Throws std::bad_alloc.
[[nodiscard]] Plane lowPassed(const Plane& plane, const Period& period, bool periodic);

} // namespace lichen::suitability
