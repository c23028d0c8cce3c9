// SPDX-License-Identifier: MIT
// Small stochastic exemplars for the tests: correlated, non-Gaussian, with several modes.
#pragma once

#include <lichen/tiling.h>

namespace lichen::test {

/// Three materials chosen by the rank of smooth noise, each with its own colour and grain, rounded
/// to 8 bits. Periodic. `blurRadius` texels set the size of the patches.
[[nodiscard]] MapExemplar threeMaterials(int width, int height, std::uint64_t seed,
                                         int blurRadius = 3);

/// The window of `map` of the given size whose top left corner is (x, y).
[[nodiscard]] MapExemplar cropped(const MapExemplar& map, int x, int y, int width, int height);

} // namespace lichen::test
