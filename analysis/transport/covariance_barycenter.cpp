// SPDX-License-Identifier: MIT
// Covariances (n of channels x channels) and weights -> a covariance (channels x channels).
#include "covariance_barycenter.h"

#include "covariance_map.h"

#include <cassert>

namespace lichen::transport {
namespace {

using Eigen::MatrixXd;

/// Of the covariance's norm. Similar covariances take under ten steps. The bound is for lines at
/// nearly right angles, between which the limit hardly matters.
constexpr double kNoChange = 1e-10;
constexpr int kMostSteps = 1000;

} // namespace

MatrixXd covarianceBarycenter(std::span<const MatrixXd> covariances,
                              std::span<const double> weights) {
  assert(!covariances.empty() && weights.size() == covariances.size());
  // From a sum, whose range holds that of every term: what the powers leave out of a rank-deficient
  // one no term has.
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
