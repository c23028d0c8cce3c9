// SPDX-License-Identifier: MIT
// The covariance between the channels of a Gaussian texture, and whether its noise can have
// another.
#pragma once

#include "gaussian_model.h"

#include <Eigen/Dense>

namespace lichen::gaussian {

/// At one point, channels x channels: the mean over all frequencies of the cross-spectra.
[[nodiscard]] Eigen::MatrixXd modelCovariance(const GaussianModel& model);

/// Whether a model of this covariance varies along every direction in which the noise is to vary.
/// What is left of a slope of light is rounding, which no gain makes a texture of.
[[nodiscard]] bool isModelled(const Eigen::MatrixXd& model, const Eigen::MatrixXd& wanted);

} // namespace lichen::gaussian
