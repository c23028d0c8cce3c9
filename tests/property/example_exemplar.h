// SPDX-License-Identifier: MIT
// Small stochastic exemplars for the tests: correlated, non-Gaussian and multimodal.
#pragma once

#include <lichen/tiling.h>

namespace lichen::test {

/// Three materials, each with its own colour and grain, selected by the rank of smooth noise.
/// Periodic; rounded to 8 bits. `blurRadius` [texels] sets the size of the patches.
[[nodiscard]] MapExemplar threeMaterials(int width, int height, std::uint64_t seed,
                                         int blurRadius = 3);

/// Returns the window of `map` of the given size whose top left corner is (x, y).
[[nodiscard]] MapExemplar cropped(const MapExemplar& map, int x, int y, int width, int height);

} // namespace lichen::test
