// SPDX-License-Identifier: MIT
// Finds the grain of a strongly oriented exemplar, such as wood.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/lattice.h>

namespace lichen::exemplar {

/// The axis nearest to the direction of a map's streaks, at any angle to it, or none if the map has
/// no long streaks. The brightness is averaged to about 256 pixels a side. Its gradients across the
/// streaks must have three times the energy of gradients along them, and pixels on a streak must
/// correlate by 0.2 at a distance of 2/7 of the side along the axis: the width along x, the height
/// along y. Slopes and maps under 64 pixels a side have no grain.
/// Source: docs/decisions/006-light-and-grain.md. Throws std::bad_alloc.
[[nodiscard]] Grain grainOf(const MapExemplar& map);

} // namespace lichen::exemplar
