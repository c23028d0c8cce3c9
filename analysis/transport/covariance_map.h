// SPDX-License-Identifier: MIT
// Principal axes and powers of covariance matrices, and the linear map from one covariance to
// another.
#pragma once

#include <Eigen/Dense>

namespace lichen::transport {

/// Up to 3 x 3, on the stack: the covariance of one map's channels. The functions that are
/// templates also take Eigen::MatrixXd.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// Eigenvalues, ascending, and unit eigenvectors of a symmetric matrix. A wrapper that compiles
/// Eigen's solver once per type, because each file that calls its constructor takes seconds to
/// compile.
template <class Matrix>
[[nodiscard]] Eigen::SelfAdjointEigenSolver<Matrix> principalAxes(const Matrix& symmetric);

/// The matrix with the same eigenvectors and with eigenvalues raised to `exponent`. `symmetric` is
/// positive semidefinite. Eigenvalues below 1e-12 of the largest are rounding of float coordinates;
/// they become zero, also for negative exponents (pseudo-inverse).
template <class Matrix>
[[nodiscard]] Matrix power(const Matrix& symmetric, double exponent);

/// The number of eigenvalues above 1e-12 of the largest.
[[nodiscard]] int rank(const SmallMatrix& symmetric);

/// (R B R)^(1/2) for `root` R, the square root of a covariance, and `covariance` B. Its eigenvalues
/// are roots of products, so only those below 1e-15 of the largest, the rounding of doubles, become
/// zero.
template <class Matrix>
[[nodiscard]] Matrix rootOfProduct(const Matrix& root, const Matrix& covariance);

/// The symmetric optimal-transport map between centred Gaussians,
/// A^(-1/2) (A^(1/2) B A^(1/2))^(1/2) A^(-1/2) for `from` A and `to` B [PC19] eq. 2.40.
template <class Matrix>
[[nodiscard]] Matrix covarianceMap(const Matrix& from, const Matrix& to);

extern template Eigen::SelfAdjointEigenSolver<SmallMatrix> principalAxes(const SmallMatrix&);
extern template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>
principalAxes(const Eigen::MatrixXd&);
extern template SmallMatrix power(const SmallMatrix&, double);
extern template Eigen::MatrixXd power(const Eigen::MatrixXd&, double);
extern template Eigen::MatrixXd rootOfProduct(const Eigen::MatrixXd&, const Eigen::MatrixXd&);
extern template SmallMatrix covarianceMap(const SmallMatrix&, const SmallMatrix&);
extern template Eigen::MatrixXd covarianceMap(const Eigen::MatrixXd&, const Eigen::MatrixXd&);

} // namespace lichen::transport
