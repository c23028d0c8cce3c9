// SPDX-License-Identifier: MIT
// Axes and powers of covariance matrices, and the linear map that carries one covariance to
// another.
#pragma once

#include <Eigen/Dense>

namespace lichen::transport {

/// Up to 3 x 3, on the stack: of one map's channels. The functions take Eigen::MatrixXd too.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// Eigenvalues, ascending, and unit eigenvectors of a symmetric matrix. Eigen's solver, compiled
/// once for each type: it takes seconds in a file that calls its constructor.
template <class Matrix>
[[nodiscard]] Eigen::SelfAdjointEigenSolver<Matrix> principalAxes(const Matrix& symmetric);

/// The symmetric matrix with the same eigenvectors and eigenvalues raised to `exponent`.
/// Eigenvalues below 1e-12 of the largest, which is the rounding of float coordinates, count as
/// zero and stay zero: the pseudo-inverse for negative exponents. `symmetric` is positive
/// semidefinite.
template <class Matrix>
[[nodiscard]] Matrix power(const Matrix& symmetric, double exponent);

/// How many eigenvalues do not count as zero.
[[nodiscard]] int rank(const SmallMatrix& symmetric);

/// (R B R)^(1/2) for `root` R, the power 1/2 of a covariance, and `covariance` B. Its eigenvalues
/// are roots of products, which count as zero below 1e-15 of the largest only: rounding of doubles.
template <class Matrix>
[[nodiscard]] Matrix rootOfProduct(const Matrix& root, const Matrix& covariance);

/// The symmetric optimal-transport map between centred Gaussians,
/// A^(-1/2) (A^(1/2) B A^(1/2))^(1/2) A^(-1/2) for `from` A and `to` B [PC19 eq. 2.40].
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
