// SPDX-License-Identifier: MIT
// A colour map as a normal map, for tests that compare slopes.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::test {

/// Slopes that a colour's first two channels happen to be.
inline MapExemplar slopesOf(MapExemplar map) {
  std::vector<float> slopes;
  for (std::size_t i = 0; i < map.values.size() / 3; ++i)
    for (std::size_t c = 0; c < 2; ++c)
      slopes.push_back(map.values[3 * i + c] - 0.5f);
  map.values = slopes;
  map.target = MapTarget::normal;
  map.channels = {MapChannel::slopeX, MapChannel::slopeY};
  map.encoding = ValueEncoding::slope;
  return map;
}

} // namespace lichen::test
