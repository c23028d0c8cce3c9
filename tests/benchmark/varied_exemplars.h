// SPDX-License-Identifier: MIT
// Exemplars of many kinds, from Gaussian fields to bricks, by which a choice of method is judged.
#pragma once

#include <lichen/image.h>

#include <string>
#include <vector>

namespace lichen::bench {

struct VariedExemplar {
  std::string name;
  SrgbImage image;
  bool isHeldBack = false; ///< never used for tuning
};

/// Ten kinds, six of each, half of them held back. They do not tile.
[[nodiscard]] std::vector<VariedExemplar> variedExemplars(int sidePixels);

} // namespace lichen::bench
