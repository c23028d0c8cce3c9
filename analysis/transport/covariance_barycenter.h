// SPDX-License-Identifier: MIT
// The covariance of the optimal-transport barycentre of centred Gaussians.
#pragma once

#include <Eigen/Dense>

#include <span>

namespace lichen::transport {

/// The covariance that minimizes sum_k weights[k] W_2^2, where W_2 is the transport distance from
/// the centred Gaussian with that covariance to the one with covariances[k]. Takes at least one
/// covariance; all have the same size and are positive semidefinite, of any rank. There are as many
/// weights as covariances; they are not negative and sum to 1. For covariances that commute, the
/// result is the square of the weighted mean of their square roots. Source: [AC11].
[[nodiscard]] Eigen::MatrixXd covarianceBarycenter(std::span<const Eigen::MatrixXd> covariances,
                                                   std::span<const double> weights);

} // namespace lichen::transport
