// SPDX-License-Identifier: MIT
// Closed-form linear map between two covariances: two sets of N points -> two sets of N points.
#include "precondition.h"

#include "covariance.h"

#include <array>

namespace lichen::transport {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Moments<SmallMatrix> momentsOf(std::span<const Point> points) {
  return transport::momentsOf<SmallMatrix>(points.size(), 3, [&](std::size_t i, int c) {
    return std::array{points[i].x, points[i].y, points[i].z}[std::size_t(c)];
  });
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
  const Moments<SmallMatrix> from = momentsOf(source), to = momentsOf(target);
  const Matrix3d map = covarianceMap(from.covariance, to.covariance);
  return {transformed(source, from.mean, power<SmallMatrix>(map, 0.5)),
          transformed(target, to.mean, power<SmallMatrix>(map, -0.5)), rank(map)};
}

} // namespace lichen::transport
