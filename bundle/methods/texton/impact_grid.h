// SPDX-License-Identifier: MIT
// The grid of cells for the impacts of texton noise, with one impact per cell on average. Cells are
// near squares on texture coordinates and cubes for surface noise.
#pragma once

#include <lichen/bundle.h>
#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

namespace lichen {

/// Cells per tile and, if the placement is periodic, per period: the integers closest to those for
/// which `impacts` impacts cover a point on average. If a period is not a whole number of tiles,
/// tile borders need not coincide with cell borders.
[[nodiscard]] Lattice impactGrid(const TextonShape& shape, double impacts,
                                 const Placement& placement);

/// The cell of an integer tile origin, modulo 2^32. A tile must be a whole number of cells.
[[nodiscard]] std::array<std::int32_t, 2> impactGridCell(const Lattice& grid, std::int64_t tileX,
                                                         std::int64_t tileY);

/// [GLM17] section 6: r, in texels, the thickness of the layer of impacts that cover a point. For a
/// texton that is not square, the side of a square of the same area.
[[nodiscard]] double surfaceThickness(const TextonShape& shape);

/// The cubes of surface noise, sized so that kSurfaceImpacts x `impacts` impacts cover a point on
/// average. Never periodic.
[[nodiscard]] Lattice surfaceGrid(const TextonShape& shape, double impacts);

} // namespace lichen
