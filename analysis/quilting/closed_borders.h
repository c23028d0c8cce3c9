// SPDX-License-Identifier: MIT
// Makes the maps of an exemplar periodic by cutting along its cells.
#pragma once

#include "progress_part.h"

#include <lichen/exemplar.h>

#include <array>
#include <span>

namespace lichen::quilting {

/// Replaces a band along the borders by what lies one of `shifts` [tiles] further, about half a
/// tile, from which it is cut along the outlines of cells; a border for which none of them is near
/// stays as it is. Without shifts, by what lies half a tile further. `count` as in cellsOf().
/// Throws std::bad_alloc and Interrupted.
void closeBorders(std::span<MapExemplar> maps, double count,
                  std::span<const std::array<double, 2>> shifts, ProgressPart progress);

} // namespace lichen::quilting
