// SPDX-License-Identifier: MIT
// Gaussian images that reproduce the correlations between the maps of a set
// (docs/decisions/004-transport.md).
#pragma once

#include "exemplar/color_space.h"
#include "gaussianize.h"
#include "inverse_table.h"

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::gaussian {

/// 262,144 blends of three taps, uniform in the image and in the lattice's triangles: one column
/// per blend. All images use the same positions and weights: the k-th columns of two maps are the
/// same blend.
struct DecodedBlends {
  Eigen::MatrixXf gaussian; ///< D rows: G with mean 0 and variance 1
  Eigen::MatrixXf values;   ///< one row per channel of the table
};

/// What later maps need from a finished map to correlate with it: 2 D floats per pixel, and blends.
struct SettledMap {
  /// Keeps a pointer to `map`, which must outlive this object.
  SettledMap(const MapExemplar& map, exemplar::ColorSpace space, const Gaussianized& gaussian,
             const InverseTable& table);

  const MapExemplar* map;
  exemplar::ColorSpace space;
  Eigen::MatrixXf matched; ///< D rows: the Gaussian points of the map's pixels, standardized
  Eigen::MatrixXf image;   ///< the same for the Gaussian image
  DecodedBlends blends;    ///< decoded values minus their mean, on the axes of `space`
};

/// Returns whether the root mean square of the missing correlations is too small to measure.
[[nodiscard]] bool isNegligible(const Eigen::MatrixXd& missing);

/// Exchanges values of `alone`, which `table` decodes, among similar pixels, so that decoded blends
/// of it and of the settled maps reproduce the covariances of the maps themselves. Returns `alone`
/// itself if that does not reduce the error. In one dimension only pixels of equal value are
/// exchanged. In more, Gaussian values move by at most a tenth of a standard deviation in the root
/// mean square, so `table` decodes the result as well. Maps of other sizes are read at the same
/// relative position. O(N log N) time, about 50 bytes per pixel. Throws Interrupted and
/// std::bad_alloc.
[[nodiscard]] Gaussianized withCrossCovariances(const MapExemplar& map,
                                                const exemplar::ColorSpace& space,
                                                std::span<const SettledMap> settled,
                                                Gaussianized alone, const InverseTable& table,
                                                gaussian::BorderTreatment borders,
                                                ProgressPart progress);

} // namespace lichen::gaussian
