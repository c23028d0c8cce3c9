// SPDX-License-Identifier: MIT
// Gaussian images of the maps of a set that belong together as the maps do
// (docs/decisions/012-correlations-between-maps.md).
#pragma once

#include "color_space.h"
#include "gaussianize.h"

#include <functional>
#include <span>
#include <vector>

namespace lichen::tiling {

/// A map whose Gaussian image later maps are to go with.
struct SettledMap {
  Gaussianized gaussian;
  std::vector<Point> values; ///< width * height, as projectedValues() gives them
};

/// (value - mean) of each pixel on the axes of `space`.
[[nodiscard]] std::vector<Point> projectedValues(const MapExemplar& map, const ColorSpace& space);

/// Gaussianizes the map from points that go with its pixels one to one.
using Gaussianizer = std::function<Gaussianized(const std::vector<Point>&)>;

/// `first`, or what `again` makes of it with its values exchanged among alike pixels so that
/// decoding blends of it and of the settled maps gives the covariances of the maps themselves.
/// In one dimension only pixels of equal value are exchanged; in more, those whose Gaussian values
/// are a tenth of a deviation apart in the root mean square, at most. `again` is called at most
/// six times, once in two and three dimensions. Maps of other sizes are read at the same place.
[[nodiscard]] Gaussianized withCrossCovariances(const MapExemplar& map, const ColorSpace& space,
                                                std::span<const SettledMap> settled,
                                                Gaussianized first, const Gaussianizer& again);

} // namespace lichen::tiling
