// SPDX-License-Identifier: MIT
// Means and covariances of sets of vectors, principal axes and powers of covariances, the linear map
// from one to another, and the barycentre of several.
#pragma once

#include <Eigen/Dense>

#include <cstddef>
#include <span>

namespace lichen::transport {

/// Up to 3 x 3, on the stack: the covariance of one map's channels. The functions that are
/// templates also take Eigen::MatrixXd.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// Eigenvalues, ascending, and unit eigenvectors of a symmetric matrix, or of a Hermitian one of
/// complex numbers. A wrapper that compiles Eigen's solver once per type, because each file that
/// calls its constructor takes seconds to compile.
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
extern template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>
principalAxes(const Eigen::MatrixXcd&);
extern template SmallMatrix power(const SmallMatrix&, double);
extern template Eigen::MatrixXd power(const Eigen::MatrixXd&, double);
extern template Eigen::MatrixXd rootOfProduct(const Eigen::MatrixXd&, const Eigen::MatrixXd&);
extern template SmallMatrix covarianceMap(const SmallMatrix&, const SmallMatrix&);
extern template Eigen::MatrixXd covarianceMap(const Eigen::MatrixXd&, const Eigen::MatrixXd&);

/// The covariance that minimizes sum_k weights[k] W_2^2, where W_2 is the transport distance from
/// the centred Gaussian with that covariance to the one with covariances[k]. Takes at least one
/// covariance; all have the same size and are positive semidefinite, of any rank. There are as many
/// weights as covariances; they are not negative and sum to 1. For covariances that commute, the
/// result is the square of the weighted mean of their square roots. Source: [AC11].
[[nodiscard]] Eigen::MatrixXd covarianceBarycenter(std::span<const Eigen::MatrixXd> covariances,
                                                   std::span<const double> weights);

template <class Matrix>
struct Moments {
  using Vector =
      Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1, 0, Matrix::MaxRowsAtCompileTime, 1>;
  Vector mean;
  Matrix covariance;
};

/// The moments of `count` (at least 1) vectors of n components; value(i, c) is component c of
/// vector i. Matrix is SmallMatrix for n up to 3, otherwise Eigen::MatrixXd. Two passes, because
/// the difference of sums of squares would lose the digits of small variances.
template <class Matrix, class Value>
[[nodiscard]] Moments<Matrix> momentsOf(std::size_t count, int n, const Value& value) {
  using Vector = typename Moments<Matrix>::Vector;
  Moments<Matrix> moments{Vector::Zero(n), Matrix::Zero(n, n)};
  for (std::size_t i = 0; i < count; ++i)
    for (int c = 0; c < n; ++c)
      moments.mean[c] += double(value(i, c));
  moments.mean /= double(count);
  Vector d(n);
  for (std::size_t i = 0; i < count; ++i) {
    for (int c = 0; c < n; ++c)
      d[c] = double(value(i, c)) - moments.mean[c];
    moments.covariance.noalias() += d * d.transpose();
  }
  moments.covariance /= double(count);
  return moments;
}

} // namespace lichen::transport
