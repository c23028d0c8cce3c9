// SPDX-License-Identifier: MIT
// Random blends of a Gaussian image and what its table decodes them to.
#pragma once

#include "gaussianize.h"
#include "inverse_table.h"

#include <Eigen/Dense>

namespace lichen::tiling {

/// A column for each blend.
struct DecodedBlends {
  Eigen::MatrixXf gaussian; ///< D rows: G with mean 0 and variance 1
  Eigen::MatrixXf values;   ///< a row for each channel of the table
};

/// 262,144 blends of three taps, uniform in the image and in the lattice's triangles. Places and
/// weights are those of every other image: the k-th columns of two maps are of one blend.
[[nodiscard]] DecodedBlends decodedBlends(const Gaussianized& gaussian, const InverseTable& table);

} // namespace lichen::tiling
