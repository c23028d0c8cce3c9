// SPDX-License-Identifier: MIT
// Random blends of a Gaussian image and the values that its table decodes them to.
#pragma once

#include "gaussianize.h"
#include "inverse_table.h"

#include <Eigen/Dense>

namespace lichen::gaussianization {

/// One column per blend.
struct DecodedBlends {
  Eigen::MatrixXf gaussian; ///< D rows: G with mean 0 and variance 1
  Eigen::MatrixXf values;   ///< one row per channel of the table
};

/// Draws 262,144 blends of three taps, uniform in the image and in the lattice's triangles. All
/// images use the same positions and weights: the k-th columns of two maps are the same blend.
[[nodiscard]] DecodedBlends decodedBlends(const Gaussianized& gaussian, const InverseTable& table);

} // namespace lichen::gaussianization
