// SPDX-License-Identifier: MIT
// The covariance between the channels of a texton's noise, and coefficients that have a given one.
#pragma once

#include "fit.h"

#include <Eigen/Dense>

namespace lichen::texton {

/// Sum over k, l of b(k - l) alpha(k) alpha(l)^T, channels x channels: the noise's covariance
/// between its channels at one point [GLM17 section 4.3].
[[nodiscard]] Eigen::MatrixXd noiseCovariance(const TextonCoefficients& coefficients, int order);

/// Multiplies the coefficients of every texel by the transport map that takes their noise's
/// covariance to `target`, symmetric where each channel is measured in its deviation, and again to
/// remove what rounding left: of every entry C_ij 1e-6 sqrt(C_ii C_jj) is left at the most, before
/// any rounding to half floats. Sums of channels in which the texton does not vary are left out
/// where they are below a thousandth, measured likewise. False, and nothing changed, where they are
/// more: no linear map does it. Rank-deficient covariances, of grey stored as RGB, are usual.
[[nodiscard]] bool correctCovariance(TextonCoefficients& coefficients, int order,
                                     const Eigen::MatrixXd& target);

} // namespace lichen::texton
