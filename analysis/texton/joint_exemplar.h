// SPDX-License-Identifier: MIT
// The maps of a noise as one image in which each quantity has the same weight.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/texton.h>

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::texton {

/// All maps at the size of the largest. Colours are one quantity, slopes another, and every other
/// channel is a quantity of its own. The unit is the standard deviation of the quantity, so that
/// the fit does not depend on the units in which a map is stored.
struct JointExemplar {
  int width = 0;
  int height = 0;
  std::vector<float> values; ///< interleaved, in units, without the mean
  Eigen::VectorXd mean;      ///< in stored values, from each map's own pixels
  Eigen::VectorXd units;     ///< stored values per unit, for each channel; above 0
  /// In units. Variances come from each map's own pixels, correlations from the resampled ones. 0
  /// for a channel without variation.
  Eigen::MatrixXd covariance;

  [[nodiscard]] int channels() const { return int(mean.size()); }
};

/// Takes at least one map, each within the ranges of MapExemplar. Throws std::bad_alloc.
[[nodiscard]] JointExemplar joinedMaps(std::span<const MapExemplar> maps);

/// Returns a usage error that names the option outside its range.
[[nodiscard]] Result<void> checkTextonOptions(const TextonOptions& options);

} // namespace lichen::texton
