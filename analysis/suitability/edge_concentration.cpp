// SPDX-License-Identifier: MIT
// Values (height, width, channels) -> concentration of the slow gradients.
#include "edge_concentration.h"

#include "calibration.h"
#include "gaussian_plane.h"
#include "low_pass.h"
#include "trend.h"

#include <algorithm>

namespace lichen::suitability {

double edgeConcentration(const MapExemplar& map, bool periodic) {
  const double period = kShortestLight * std::max(map.width, map.height);
  const Plane plane{map.width, map.height, principalComponent(map).values};
  const Plane slow = lowPassed(plane, trendOf(plane, periodic), {period, period}, periodic);
  const auto at = [&](int x, int y) {
    return double(slow.values[std::size_t(y) * std::size_t(slow.width) + std::size_t(x)]);
  };
  // Forward differences suffice: the plane has no variation at the scale of a pixel.
  double squares = 0.0, fourths = 0.0;
  for (int y = 0; y + 1 < slow.height; ++y)
    for (int x = 0; x + 1 < slow.width; ++x) {
      const double right = at(x + 1, y) - at(x, y), down = at(x, y + 1) - at(x, y);
      const double square = right * right + down * down;
      squares += square;
      fourths += square * square;
    }
  const double count = double(slow.width - 1) * double(slow.height - 1);
  return squares > 0.0 ? count * fourths / (squares * squares) : 0.0;
}

} // namespace lichen::suitability
