// SPDX-License-Identifier: MIT
// The generated pictures, each made once for all cases of a test: making one takes longer than
// judging it.
#pragma once

#include "measured_cloudiness.h"

#include <map>
#include <utility>

namespace lichen::test {

/// What one of the generators of lichen::exemplars makes of this side, as a map of base colours.
inline const MapExemplar& generatedExemplar(SrgbImage (*generate)(int sidePixels), int sidePixels) {
  static std::map<std::pair<SrgbImage (*)(int), int>, MapExemplar> made;
  const auto [place, isNew] = made.try_emplace({generate, sidePixels});
  if (isNew)
    place->second = baseColor(generate(sidePixels));
  return place->second;
}

} // namespace lichen::test
