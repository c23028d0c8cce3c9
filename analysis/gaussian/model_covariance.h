// SPDX-License-Identifier: MIT
// The covariance between the channels of a Gaussian texture, and whether its noise can have a
// different one.
#pragma once

#include "gaussian_model.h"

#include <Eigen/Dense>

namespace lichen::gaussian {

/// Returns the covariance at one point, channels x channels: the mean of the cross-spectra over all
/// frequencies.
[[nodiscard]] Eigen::MatrixXd modelCovariance(const GaussianModel& model);

/// Returns whether a model of covariance `model` varies along every direction in which the noise
/// must vary. A pure brightness gradient leaves only rounding in the model, and no gain turns that
/// into a texture.
[[nodiscard]] bool isModelled(const Eigen::MatrixXd& model, const Eigen::MatrixXd& wanted);

} // namespace lichen::gaussian
