// SPDX-License-Identifier: MIT
// Covariances (n of channels x channels) and weights -> a covariance (channels x channels).
#include "covariance_barycenter.h"

#include "covariance_map.h"

#include <cassert>

namespace lichen::transport {
namespace {

using Eigen::MatrixXd;

/// Relative to the covariance's norm. Similar covariances take under ten steps. Only rank-one
/// covariances at nearly right angles reach the step limit, where the choice hardly matters.
constexpr double kNoChange = 1e-10;
constexpr int kMostSteps = 1000;

} // namespace

MatrixXd covarianceBarycenter(std::span<const MatrixXd> covariances,
                              std::span<const double> weights) {
  assert(!covariances.empty() && weights.size() == covariances.size());
  // Starts from a sum, whose range contains the range of every term. The directions that power()
  // drops from a rank-deficient sum are therefore absent from every term.
  MatrixXd result = MatrixXd::Zero(covariances[0].rows(), covariances[0].cols());
  for (std::size_t k = 0; k < covariances.size(); ++k)
    result += weights[k] * covariances[k];
  for (int step = 0; step < kMostSteps; ++step) {
    // [AEBC16] theorem 4.2
    const MatrixXd root = power(result, 0.5);
    const MatrixXd inverseRoot = power(result, -0.5);
    MatrixXd mean = MatrixXd::Zero(result.rows(), result.cols());
    for (std::size_t k = 0; k < covariances.size(); ++k)
      mean += weights[k] * rootOfProduct(root, covariances[k]);
    const MatrixXd next = inverseRoot * mean * mean * inverseRoot;
    const double change = (next - result).norm();
    result = next;
    if (change <= kNoChange * result.norm())
      break;
  }
  return result;
}

} // namespace lichen::transport
