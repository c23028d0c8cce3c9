// SPDX-License-Identifier: MIT
// The covariance between others: that of the barycentre of Gaussians for the transport distance.
#pragma once

#include <Eigen/Dense>

#include <span>

namespace lichen::transport {

/// The covariance of the law that has the least sum_k weights[k] (transport distance to the centred
/// Gaussian of covariances[k])^2. At least one covariance, all of one size, positive semidefinite
/// of any rank; a weight each, none negative, of sum 1. Covariances that commute: the square of the
/// mean of the roots. Source: [AC11].
[[nodiscard]] Eigen::MatrixXd covarianceBarycenter(std::span<const Eigen::MatrixXd> covariances,
                                                   std::span<const double> weights);

} // namespace lichen::transport
