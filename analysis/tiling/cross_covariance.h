// SPDX-License-Identifier: MIT
// Gaussian images of the maps of a set that belong together as the maps do
// (docs/decisions/012-correlations-between-maps.md).
#pragma once

#include "color_space.h"
#include "gaussianize.h"
#include "inverse_table.h"

#include <functional>
#include <span>
#include <vector>

namespace lichen::tiling {

/// A map whose Gaussian image later maps are to go with.
struct SettledMap {
  Gaussianized gaussian;
  std::vector<Point> values; ///< width * height stored values less their mean, on the map's axes
  InverseTable table;        ///< of the same, as many channels as axes
};
[[nodiscard]] SettledMap settledMap(const MapExemplar& map, const ColorSpace& space,
                                    Gaussianized gaussian, const InverseTable& table);

/// Gaussianizes the map from points that go with its pixels one to one.
using Gaussianizer = std::function<Gaussianized(const std::vector<Point>&)>;

/// `first`, which `table` decodes, or what `again` makes of it with its values exchanged among
/// alike pixels so that decoding blends of it and of the settled maps gives the covariances of the
/// maps themselves. In one dimension only pixels of equal value are exchanged; in more, those whose
/// Gaussian values are a tenth of a deviation apart in the root mean square, at most. `again` is
/// called at most six times, once in two and three dimensions. Maps of other sizes are read at the
/// same place.
[[nodiscard]] Gaussianized withCrossCovariances(const MapExemplar& map, const ColorSpace& space,
                                                std::span<const SettledMap> settled,
                                                Gaussianized first, const InverseTable& table,
                                                const Gaussianizer& again);

} // namespace lichen::tiling
