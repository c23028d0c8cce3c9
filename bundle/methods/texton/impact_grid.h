// SPDX-License-Identifier: MIT
// The grid of cells in which the impacts of texton noise lie, one in the mean in each: squares, or
// of surface noise cubes.
#pragma once

#include <lichen/bundle.h>
#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

namespace lichen {

/// Cells per tile and, where the placement is periodic, per period: the whole numbers nearest to
/// what gives a point `impacts` impacts in the mean. Cells of a periodic grid whose period is not
/// a whole number of tiles do not end with the tile.
[[nodiscard]] Lattice impactGrid(const TextonShape& shape, double impacts,
                                 const Placement& placement);

/// The cell in which an integer tile origin lies, modulo 2^32. A tile is a whole number of cells.
[[nodiscard]] LatticeOrigin impactGridOrigin(const Lattice& grid, std::int64_t tileX,
                                             std::int64_t tileY);

/// The r of [GLM17] section 6, in texels: how thick a layer of impacts a point sees. For a texton
/// that is not square, the side of the square of its area.
[[nodiscard]] double surfaceThickness(const TextonShape& shape);

/// Of surface noise: cubes, of which a point sees kSurfaceImpacts x `impacts` in the mean. Never
/// periodic.
[[nodiscard]] Lattice surfaceGrid(const TextonShape& shape, double impacts);

} // namespace lichen
