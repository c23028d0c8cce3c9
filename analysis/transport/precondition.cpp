// SPDX-License-Identifier: MIT
// Closed-form linear map between two covariances; inputs N points each -> N points each.
#include "precondition.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace lichen::transport {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Eigenvalues below this share of the largest are directions in which a set does not vary: float
/// coordinates carry 24 bits, so (2^-20)^2 of the largest variance is rounding.
constexpr double kNoVariance = 1e-12;

Vector3d meanOf(std::span<const Point> points) {
  Vector3d sum = Vector3d::Zero();
  for (const Point& p : points)
    sum += Vector3d(p.x, p.y, p.z);
  return sum / double(points.size());
}

Matrix3d covarianceOf(std::span<const Point> points, const Vector3d& mean) {
  Matrix3d sum = Matrix3d::Zero();
  for (const Point& p : points) {
    const Vector3d d = Vector3d(p.x, p.y, p.z) - mean;
    sum += d * d.transpose();
  }
  return sum / double(points.size());
}

/// The symmetric matrix with the same eigenvectors and eigenvalues raised to `exponent`;
/// eigenvalues that count as zero stay zero (the pseudo-inverse for negative exponents).
Matrix3d power(const Matrix3d& symmetric, double exponent) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(symmetric);
  const Vector3d values = solver.eigenvalues();
  const double floor = kNoVariance * std::max(values.maxCoeff(), 0.0);
  Vector3d powered = Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    if (values[k] > floor)
      powered[k] = std::pow(values[k], exponent);
  return solver.eigenvectors() * powered.asDiagonal() * solver.eigenvectors().transpose();
}

std::vector<Point> transformed(std::span<const Point> points, const Vector3d& mean,
                               const Matrix3d& matrix) {
  std::vector<Point> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d v = matrix * (Vector3d(points[i].x, points[i].y, points[i].z) - mean);
    result[i] = {float(v[0]), float(v[1]), float(v[2])};
  }
  return result;
}

} // namespace

PointPair precondition(std::span<const Point> source, std::span<const Point> target) {
  const Vector3d sourceMean = meanOf(source);
  const Vector3d targetMean = meanOf(target);
  const Matrix3d a = covarianceOf(source, sourceMean);
  const Matrix3d b = covarianceOf(target, targetMean);
  const Matrix3d rootA = power(a, 0.5);
  const Matrix3d inverseRootA = power(a, -0.5);
  const Matrix3d map = inverseRootA * power(rootA * b * rootA, 0.5) * inverseRootA;
  return {transformed(source, sourceMean, power(map, 0.5)),
          transformed(target, targetMean, power(map, -0.5))};
}

} // namespace lichen::transport
