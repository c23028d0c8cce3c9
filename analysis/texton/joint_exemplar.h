// SPDX-License-Identifier: MIT
// All maps of an exemplar as one image, so that one texton is fitted to all.
#pragma once

#include <lichen/tiling.h>

#include <Eigen/Dense>

#include <cstddef>
#include <span>
#include <vector>

namespace lichen::texton {

/// `channels` interleaved values a pixel, those of the first map first.
struct JointExemplar {
  int width = 0;
  int height = 0;
  std::size_t channels = 0;
  std::vector<float> values;
  Eigen::VectorXd mean;       ///< of each map's own pixels
  Eigen::MatrixXd covariance; ///< likewise; between maps of different sizes, of the resampled ones
};

/// Maps of other sizes are resampled to the widest and highest. At least one. Throws
/// std::bad_alloc.
[[nodiscard]] JointExemplar joined(std::span<const MapExemplar> maps);

} // namespace lichen::texton
