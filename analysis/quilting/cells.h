// SPDX-License-Identifier: MIT
// The cells of an exemplar: what edges enclose, such as bricks, stones, chips or threads.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>

#include <array>
#include <span>
#include <vector>

namespace lichen::quilting {

/// For each texel of a width x height grid over the tile, the vector to the centre of its cell, and
/// how strong edges around it are.
struct CellField {
  int width = 0, height = 0;
  std::vector<std::array<float, 2>> toCentre; ///< [tiles]
  std::vector<float> edges;                   ///< magnitude of the gradient, smoothed
};

/// Spreads the coordinates of all points within what edges enclose, so that each cell gets the
/// coordinates of its centre: solves g laplace(P) = lambda (P - p), with a conductance g that falls
/// where the gradient of the maps is high. Where nothing is enclosed across an axis, the coordinate
/// along it stays as it is. Edges themselves belong to the nearest cell. `count` is about the
/// number of cells in a tile; much larger ones are divided. The maps must be periodic, and only the
/// largest count. Throws std::bad_alloc.
[[nodiscard]] CellField cellsOf(std::span<const MapExemplar> maps, double count);

/// The image of cells that QuiltingMap describes, with 8 or 16 bits per channel, and its reach.
struct CellImage {
  Table table;
  double reach = 0.0; ///< [tiles]
};
[[nodiscard]] CellImage cellImage(const CellField& cells, int bits);

} // namespace lichen::quilting
