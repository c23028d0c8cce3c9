// SPDX-License-Identifier: MIT
// The maps of a noise as one image, in which each of its quantities counts alike.
#pragma once

#include <lichen/exemplar.h>

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::texton {

/// All maps at the size of the largest. Colours are one quantity, slopes another, and every other
/// channel is one by itself; a unit is a deviation of the quantity, so that the fit does not depend
/// on the units in which a map happens to be stored.
struct JointExemplar {
  int width = 0;
  int height = 0;
  std::vector<float> values; ///< interleaved, in units from the mean
  Eigen::VectorXd mean;      ///< stored values, of each map's own pixels
  Eigen::VectorXd units;     ///< stored values a unit, of each channel; above 0
  /// In units; variances of each map's own pixels, correlations of the resampled ones. 0 for a
  /// channel without variation.
  Eigen::MatrixXd covariance;

  [[nodiscard]] int channels() const { return int(mean.size()); }
};

/// At least one map, each within the ranges of MapExemplar. Throws std::bad_alloc.
[[nodiscard]] JointExemplar joinedMaps(std::span<const MapExemplar> maps);

} // namespace lichen::texton
