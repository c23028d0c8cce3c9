// SPDX-License-Identifier: MIT
// Finds the grain of a strongly oriented exemplar, such as wood.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/lattice.h>

namespace lichen::exemplar {

/// The axis nearest to the direction of a map's streaks, or none if it has no long ones. The
/// gradients must have three times as much energy across the direction as along it, as brightness
/// averaged to 256 pixels a side shows them, and pixels two sevenths of the side apart along it
/// must correlate by 0.2. Slopes and maps under 64 pixels a side have no grain.
/// Source: docs/decisions/036-grain.md. Throws std::bad_alloc.
[[nodiscard]] Grain grainOf(const MapExemplar& map);

} // namespace lichen::exemplar
