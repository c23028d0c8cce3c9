// SPDX-License-Identifier: MIT
// Heights (height, width) -> slopes (height, width, 2).
#include "as_seen.h"

#include "exemplar/color_space.h"
#include "exemplar/value_encoding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lichen::suitability {
namespace {

/// Standard deviation of a slope component, root mean square over both. The normal maps that come
/// with three height maps have 0.036, 0.23 and 0.27 (docs/decisions/007-verdicts.md). This is
/// the steepest, which shows slow variation best.
constexpr double kReliefDeviation = 0.27;

/// Half the difference between a pixel's two neighbours; the full difference if one of them is the
/// pixel itself.
float difference(float before, float after, bool oneSided) {
  return oneSided ? after - before : 0.5f * (after - before);
}

} // namespace

MapExemplar slopesOfHeight(const MapExemplar& map, bool periodic) {
  MapExemplar slopes;
  slopes.target = MapTarget::normal;
  slopes.channels = {MapChannel::slopeX, MapChannel::slopeY};
  slopes.encoding = ValueEncoding::slope;
  slopes.width = map.width;
  slopes.height = map.height;
  slopes.values.reserve(2 * map.values.size());
  std::vector<float> heights(map.values.size());
  std::transform(map.values.begin(), map.values.end(), heights.begin(),
                 [&](float value) { return exemplar::decoded(value, map.encoding); });
  const auto at = [&](int x, int y) {
    return heights[std::size_t(y) * std::size_t(map.width) + std::size_t(x)];
  };
  const auto neighbour = [periodic](int place, int step, int side) {
    return periodic ? (place + step + side) % side : std::clamp(place + step, 0, side - 1);
  };
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const int left = neighbour(x, -1, map.width), right = neighbour(x, 1, map.width);
      const int up = neighbour(y, -1, map.height), down = neighbour(y, 1, map.height);
      slopes.values.push_back(difference(at(left, y), at(right, y), left == x || right == x));
      slopes.values.push_back(difference(at(x, down), at(x, up), up == y || down == y));
    }
  const double variance = exemplar::momentsOf(slopes.values, 2).covariance.trace() / 2.0;
  if (variance <= 0.0)
    return slopes;
  const auto scale = float(kReliefDeviation / std::sqrt(variance));
  for (float& slope : slopes.values)
    slope *= scale;
  slopes.quantum = std::min(1.0, map.quantum * double(scale));
  return slopes;
}

} // namespace lichen::suitability
