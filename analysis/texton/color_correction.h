// SPDX-License-Identifier: MIT
// The covariance between the channels of a texton's noise, and coefficients that have a given one.
#pragma once

#include "fit.h"

#include <Eigen/Dense>

namespace lichen::texton {

/// Sum over k, l of b(k - l) alpha(k) alpha(l)^T, channels x channels: the noise's covariance
/// between its channels at one point [GLM17 section 4.3].
[[nodiscard]] Eigen::MatrixXd noiseCovariance(const TextonCoefficients& coefficients, int order);

/// Multiplies the coefficients of every texel by the symmetric transport map that takes their
/// noise's covariance to `target`, and again to remove what rounding left: relative to the target's
/// norm 1e-6 is left at the most. False, and nothing changed, where no linear map does it: where
/// channels, or sums of channels, are to vary and the texton's do not. Rank-deficient covariances,
/// of grey stored as RGB, are usual.
[[nodiscard]] bool correctCovariance(TextonCoefficients& coefficients, int order,
                                     const Eigen::MatrixXd& target);

} // namespace lichen::texton
