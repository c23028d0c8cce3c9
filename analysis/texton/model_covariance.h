// SPDX-License-Identifier: MIT
// The covariance between the channels of a Gaussian texture.
#pragma once

#include "fit.h"

#include <Eigen/Dense>

namespace lichen::texton {

/// At one point, channels x channels: the mean over all frequencies of the cross-spectra.
[[nodiscard]] Eigen::MatrixXd modelCovariance(const GaussianModel& model);

} // namespace lichen::texton
