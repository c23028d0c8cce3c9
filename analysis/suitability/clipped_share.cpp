// SPDX-License-Identifier: MIT
// Values (height, width, channels) -> shares of white and black pixels.
#include "clipped_share.h"

#include <algorithm>

namespace lichen::suitability {

ClippedShare clippedShare(const MapExemplar& map) {
  if (map.target != MapTarget::baseColor || map.encoding != ValueEncoding::srgb)
    return {};
  const auto halfQuantum = float(0.5 * map.quantum);
  std::size_t white = 0, black = 0;
  const auto channels = std::ptrdiff_t(map.channels.size());
  for (auto pixel = map.values.begin(); pixel != map.values.end(); pixel += channels) {
    const auto [least, most] = std::minmax_element(pixel, pixel + channels);
    white += std::size_t(*least >= 1.0f - halfQuantum);
    black += std::size_t(*most <= halfQuantum);
  }
  const double pixels = double(map.values.size()) / double(channels);
  return {double(white) / pixels, double(black) / pixels};
}

} // namespace lichen::suitability
