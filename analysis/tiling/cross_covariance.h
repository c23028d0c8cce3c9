// SPDX-License-Identifier: MIT
// Gaussian images of the maps of a set that belong together as the maps do
// (docs/decisions/014-correlations-between-maps.md).
#pragma once

#include "decoded_blends.h"
#include "exemplar/color_space.h"
#include "gaussianize.h"
#include "inverse_table.h"

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::tiling {

/// What later maps go with of a map that they are to go with: 2 D floats a pixel, and its blends.
struct SettledMap {
  /// Refers to `map` as long as it lives.
  SettledMap(const MapExemplar& map, exemplar::ColorSpace space, const Gaussianized& gaussian,
             const InverseTable& table);

  const MapExemplar* map;
  exemplar::ColorSpace space;
  Eigen::MatrixXf matched; ///< D rows: the Gaussian points of the map's pixels, standardized
  Eigen::MatrixXf image;   ///< the same of the Gaussian image
  DecodedBlends blends;    ///< decoded to values less their mean, on the axes of `space`
};

/// A Gaussian image and the points that it was matched from; none where it is as it was, or where
/// only ties were exchanged, on a line.
struct JoinedImage {
  Gaussianized gaussian;
  std::vector<Point> points{};
};

/// Whether correlations lack so little, in the root mean square, that blends could not tell.
[[nodiscard]] bool isNegligible(const Eigen::MatrixXd& lack);

/// `alone`, which `table` decodes, with its values exchanged among alike pixels so that decoding
/// blends of it and of the settled maps gives the covariances of the maps themselves; `alone`
/// itself where that brings them no nearer. In one dimension only pixels of equal value are
/// exchanged; in more, those whose Gaussian values are a tenth of a deviation apart in the root
/// mean square, at most: `table` decodes the result as well. Maps of other sizes are read at the
/// same place. O(N log N) time, about 50 bytes a pixel. Throws Interrupted and std::bad_alloc.
[[nodiscard]] JoinedImage withCrossCovariances(const MapExemplar& map,
                                               const exemplar::ColorSpace& space,
                                               std::span<const SettledMap> settled,
                                               Gaussianized alone, const InverseTable& table,
                                               bool periodic, ProgressPart progress);

} // namespace lichen::tiling
