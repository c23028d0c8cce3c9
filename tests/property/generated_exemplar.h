// SPDX-License-Identifier: MIT
// Generated pictures, each made once for all cases of a test, because generating one takes longer
// than judging it.
#pragma once

#include "base_color.h"

#include <map>
#include <utility>

namespace lichen::test {

/// Returns the output of a generator of lichen::exemplars at this side as a base-colour map.
inline const MapExemplar& generatedExemplar(SrgbImage (*generate)(int sidePixels), int sidePixels) {
  static std::map<std::pair<SrgbImage (*)(int), int>, MapExemplar> made;
  const auto [place, isNew] = made.try_emplace({generate, sidePixels});
  if (isNew)
    place->second = baseColor(generate(sidePixels));
  return place->second;
}

} // namespace lichen::test
