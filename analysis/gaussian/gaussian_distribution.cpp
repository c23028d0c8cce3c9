// SPDX-License-Identifier: MIT
// count -> count stratified samples of the Gaussian of [HN18].
#include "gaussian_distribution.h"

#include "transport/covariance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen::gaussian {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Mirrors the digits of i in `base` behind the point and adds half a unit of the last digit that
/// `count` points fill, so that no sample is 0.
double shiftedRadicalInverse(std::size_t i, std::size_t base, std::size_t count) {
  double inverse = 0.0;
  double place = 1.0;
  for (std::size_t range = 1; range < count; range *= base) {
    place /= double(base);
    inverse += double(i % base) * place;
    i /= base;
  }
  return inverse + 0.5 * place;
}

/// Clamping loses variance, and the whitening that restores it causes a little more clamping. For
/// 65,536 points the covariance error is 5e-3 of the variance when clamped, and 1.2e-4, 3e-6, 8e-8,
/// 2e-9 after 1 to 4 passes. Rounding to 8 bits leaves 4e-5, so two passes would do.
constexpr int kWhiteningPasses = 4;

/// Columns are points. Sets the mean to 1/2 and the covariance to I / 36 with the inverse square
/// root of the measured covariance, which is the least change in the mean square.
void whiten(MatrixXd& points) {
  const VectorXd mean = points.rowwise().mean();
  points.colwise() -= mean;
  const MatrixXd covariance = points * points.transpose() / double(points.cols());
  const auto solver = transport::principalAxes(covariance);
  const double variance = kGaussianDeviation * kGaussianDeviation;
  // If there are no more points than dimensions, directions without variance get none. Their
  // eigenvalues are below 1e-15 of the variance; the least of any larger set is 0.08 (4 points).
  constexpr double kNoVariance = 1e-9;
  VectorXd scale(covariance.rows());
  for (Eigen::Index k = 0; k < scale.size(); ++k) {
    const double value = solver.eigenvalues()[k];
    scale[k] = value > kNoVariance * variance ? std::sqrt(variance / value) : 1.0;
  }
  points = solver.eigenvectors() * scale.asDiagonal() * solver.eigenvectors().transpose() * points;
  points.array() += kGaussianMean;
}

/// Whitens the points, and for 8 bits clamps and rounds them. Missing rows become 0.
std::vector<Point> storedPoints(MatrixXd& points, Precision precision) {
  whiten(points);
  if (precision == Precision::bits8) {
    // Codes 0 to 255, of which 128 stands for the mean.
    constexpr double kSteps = 255.0;
    constexpr double kShift = 128.0 / kSteps - kGaussianMean;
    for (int pass = 0; pass < kWhiteningPasses; ++pass) {
      points = points.cwiseMax(-kShift).cwiseMin(1.0 - kShift);
      whiten(points);
    }
    const auto codes = (points.array() + kShift).max(0.0).min(1.0) * kSteps;
    points = (codes.round() / kSteps - kShift).matrix();
  }
  std::vector<Point> result(std::size_t(points.cols()));
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto column = Eigen::Index(i);
    const auto coordinate = [&](Eigen::Index row) {
      return row < points.rows() ? float(points(row, column)) : 0.0f;
    };
    result[i] = {coordinate(0), coordinate(1), coordinate(2)};
  }
  return result;
}

} // namespace

double gaussianCdf(double value) {
  return 0.5 * std::erfc(-3.0 * std::numbers::sqrt2 * (value - kGaussianMean));
}

double gaussianQuantile(double u) {
  // AS 241, PPND7: a rational function near the median, and two of sqrt(-log tail) outside.
  const double q = u - 0.5;
  double deviate = 0.0;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    deviate = q * (((59.109374720 * r + 159.29113202) * r + 50.434271938) * r + 3.3871327179) /
              (((67.187563600 * r + 78.757757664) * r + 17.895169469) * r + 1.0);
  } else {
    double r = std::sqrt(-std::log(q < 0.0 ? u : 1.0 - u));
    if (r <= 5.0) {
      r -= 1.6;
      deviate = (((0.17023821103 * r + 1.3067284816) * r + 2.7568153900) * r + 1.4234372777) /
                ((0.12021132975 * r + 0.73700164250) * r + 1.0);
    } else {
      r -= 5.0;
      deviate = (((0.017337203997 * r + 0.42868294337) * r + 3.0812263860) * r + 6.6579051150) /
                ((0.012258202635 * r + 0.24197894225) * r + 1.0);
    }
    deviate = q < 0.0 ? -deviate : deviate;
  }
  return kGaussianMean + kGaussianDeviation * deviate;
}

std::vector<Point> whitenedForStorage(const std::vector<Point>& points, int dimensions,
                                      Precision precision) {
  MatrixXd columns(dimensions, Eigen::Index(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<float, 3> p{points[i].x, points[i].y, points[i].z};
    for (Eigen::Index row = 0; row < columns.rows(); ++row)
      columns(row, Eigen::Index(i)) = double(p[std::size_t(row)]);
  }
  return storedPoints(columns, precision);
}

std::vector<Point> stratifiedGaussian(std::size_t count, int dimensions, Precision precision) {
  MatrixXd points(dimensions, Eigen::Index(count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = Eigen::Index(i);
    points(0, column) = gaussianQuantile((double(i) + 0.5) / double(count));
    if (dimensions > 1)
      points(1, column) = gaussianQuantile(shiftedRadicalInverse(i, 2, count));
    if (dimensions > 2)
      points(2, column) = gaussianQuantile(shiftedRadicalInverse(i, 3, count));
  }
  return storedPoints(points, precision);
}

} // namespace lichen::gaussian
