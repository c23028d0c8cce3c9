// SPDX-License-Identifier: MIT
// Makes the maps of an exemplar periodic by cutting along its cells.
#pragma once

#include "fitting_shifts.h"
#include "progress_part.h"

#include <lichen/exemplar.h>

#include <span>

namespace lichen::quilting {

/// Replaces cells along the borders by what lies one of `shifts` [tiles] further, about half a
/// tile, from which it is cut along the outlines of cells. If none is near, by what lies half a
/// tile further if the shifts are not close, and otherwise it stays as it is. `cells` are those
/// of the maps, `count` as in cellsOf(). Throws std::bad_alloc and Interrupted.
void closeBorders(std::span<MapExemplar> maps, const CellField& cells, double count,
                  const FittingShifts& shifts, ProgressPart progress);

} // namespace lichen::quilting
