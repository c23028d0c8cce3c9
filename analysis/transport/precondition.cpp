// SPDX-License-Identifier: MIT
// Closed-form linear map between two covariances: two sets of N points -> two sets of N points.
#include "precondition.h"

#include "covariance_map.h"

namespace lichen::transport {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

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
  const Matrix3d map = covarianceMap<SmallMatrix>(covarianceOf(source, sourceMean),
                                                  covarianceOf(target, targetMean));
  return {transformed(source, sourceMean, power<SmallMatrix>(map, 0.5)),
          transformed(target, targetMean, power<SmallMatrix>(map, -0.5)), rank(map)};
}

} // namespace lichen::transport
