// SPDX-License-Identifier: MIT
// Makes the maps of an exemplar periodic by cutting along its cells.
#pragma once

#include "fitting_shifts.h"
#include "progress_part.h"

#include <lichen/exemplar.h>

#include <span>

namespace lichen::quilting {

/// Replaces cells along borders that do not look alike by what lies one of `shifts` [tiles]
/// further, about half a tile, from which it is cut along the outlines of cells. If no shift is
/// near, by what lies half a tile further if the shifts are not close, and otherwise the border
/// stays as it is. The means of the maps hardly change. Returns whether any border was closed.
/// `cells` belong to the maps, `count` is as in cellsOf(). Throws std::bad_alloc and Interrupted.
/// Source: docs/decisions/012-quilting.md.
bool closeBorders(std::span<MapExemplar> maps, const CellField& cells, double count,
                  const FittingShifts& shifts, ProgressPart progress);

} // namespace lichen::quilting
