// SPDX-License-Identifier: MIT
// Mean and covariance of any set of vectors.
#pragma once

#include <Eigen/Dense>

#include <cstddef>

namespace lichen::transport {

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
