// SPDX-License-Identifier: MIT
// Two covariances -> the symmetric map between them.
#include "covariance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lichen::transport {
namespace {

/// Variances below this share of the largest are rounding: (2^-20)^2, because a sum of many floats
/// of 24 bits is exact to about 20.
constexpr double kNoVariance = 1e-12;
/// For products of two covariances: the rounding of the solver itself, relative to the largest.
constexpr double kNoProduct = 1e-15;

template <class Matrix>
Matrix powerAbove(const Matrix& symmetric, double exponent, double share) {
  const auto solver = principalAxes(symmetric);
  auto values = solver.eigenvalues();
  const double floor = share * std::max(values.maxCoeff(), 0.0);
  for (Eigen::Index k = 0; k < values.size(); ++k)
    values[k] = values[k] > floor ? std::pow(values[k], exponent) : 0.0;
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

} // namespace

template <class Matrix>
Eigen::SelfAdjointEigenSolver<Matrix> principalAxes(const Matrix& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(symmetric);
}

template <class Matrix>
Matrix power(const Matrix& symmetric, double exponent) {
  return powerAbove(symmetric, exponent, kNoVariance);
}

int rank(const SmallMatrix& symmetric) {
  const auto solver = principalAxes(symmetric);
  const double floor = kNoVariance * std::max(solver.eigenvalues().maxCoeff(), 0.0);
  return int((solver.eigenvalues().array() > floor).count());
}

template <class Matrix>
Matrix rootOfProduct(const Matrix& root, const Matrix& covariance) {
  return powerAbove(Matrix(root * covariance * root), 0.5, kNoProduct);
}

template <class Matrix>
Matrix covarianceMap(const Matrix& from, const Matrix& to) {
  const Matrix root = power(from, 0.5);
  const Matrix inverseRoot = power(from, -0.5);
  return inverseRoot * rootOfProduct(root, to) * inverseRoot;
}

template Eigen::SelfAdjointEigenSolver<SmallMatrix> principalAxes(const SmallMatrix&);
template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> principalAxes(const Eigen::MatrixXd&);
template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> principalAxes(const Eigen::MatrixXcd&);
template SmallMatrix power(const SmallMatrix&, double);
template Eigen::MatrixXd power(const Eigen::MatrixXd&, double);
template Eigen::MatrixXd rootOfProduct(const Eigen::MatrixXd&, const Eigen::MatrixXd&);
template SmallMatrix covarianceMap(const SmallMatrix&, const SmallMatrix&);
template Eigen::MatrixXd covarianceMap(const Eigen::MatrixXd&, const Eigen::MatrixXd&);

// Covariances (n of channels x channels) and weights -> a covariance (channels x channels).
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
