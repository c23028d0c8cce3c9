// SPDX-License-Identifier: MIT
// Covariance between the channels of a texton's noise, and coefficients with a given covariance.
#pragma once

#include "fit.h"

#include <Eigen/Dense>

namespace lichen::texton {

/// Returns the sum over k, l of b(k - l) alpha(k) alpha(l)^T, channels x channels: the covariance
/// between the channels of the noise at one point [GLM17 section 4.3].
[[nodiscard]] Eigen::MatrixXd noiseCovariance(const TextonCoefficients& coefficients, int order);

/// Multiplies the coefficients of every texel by the transport map from their noise's covariance to
/// `target`, then repeats this to remove rounding errors. The map is symmetric when each channel is
/// measured in its standard deviations. The error of every entry C_ij is at most 1e-6 sqrt(C_ii
/// C_jj), before any rounding to half floats.
/// Combinations of channels in which the texton does not vary are ignored if the target is below a
/// thousandth there, in the same measure. If it is above, no linear map can help: returns false and
/// changes nothing. Rank-deficient covariances, as of grey stored as RGB, are usual.
[[nodiscard]] bool correctCovariance(TextonCoefficients& coefficients, int order,
                                     const Eigen::MatrixXd& target);

} // namespace lichen::texton
