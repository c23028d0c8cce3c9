// SPDX-License-Identifier: MIT
// Two covariances -> the symmetric map between them.
#include "covariance_map.h"

#include <algorithm>
#include <cmath>

namespace lichen::transport {
namespace {

/// (2^-20)^2: float coordinates carry 24 bits, of which sums of many keep about 20.
constexpr double kNoVariance = 1e-12;

} // namespace

SmallMatrix power(const SmallMatrix& symmetric, double exponent) {
  const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(symmetric);
  const auto& values = solver.eigenvalues();
  const double floor = kNoVariance * std::max(values.maxCoeff(), 0.0);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> powered(values.size());
  for (Eigen::Index k = 0; k < values.size(); ++k)
    powered[k] = values[k] > floor ? std::pow(values[k], exponent) : 0.0;
  return solver.eigenvectors() * powered.asDiagonal() * solver.eigenvectors().transpose();
}

int rank(const SmallMatrix& symmetric) {
  const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(symmetric, Eigen::EigenvaluesOnly);
  const double floor = kNoVariance * std::max(solver.eigenvalues().maxCoeff(), 0.0);
  return int((solver.eigenvalues().array() > floor).count());
}

SmallMatrix covarianceMap(const SmallMatrix& from, const SmallMatrix& to) {
  const SmallMatrix root = power(from, 0.5);
  const SmallMatrix inverseRoot = power(from, -0.5);
  return inverseRoot * power(root * to * root, 0.5) * inverseRoot;
}

} // namespace lichen::transport
