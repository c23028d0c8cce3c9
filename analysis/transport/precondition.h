// SPDX-License-Identifier: MIT
// Gives two point sets the same covariance without changing their optimal matching.
#pragma once

#include "point.h"

#include <span>
#include <vector>

namespace lichen::transport {

/// Two centred sets with the same covariance, on the subspace that both span.
struct PointPair {
  std::vector<Point> source;
  std::vector<Point> target;
  int dimensions = 3; ///< of the subspace that both span, 0 to 3
};

/// X' = M^(1/2) (X - E X), Y' = M^(-1/2) (Y - E Y), with M the symmetric map from the covariance A
/// of X to the covariance B of Y, M = A^(-1/2) (A^(1/2) B A^(1/2))^(1/2) A^(-1/2) [PC19] eq. 2.40.
/// A bijection that minimizes sum |x - y|^2 maximizes sum <x, y> = sum <X', Y'> + const, so both
/// problems have the same solutions. The solution for X' and Y' is close to the identity, which
/// partitions find well. Directions in which X does not vary do not count and are 0 in X' and Y'.
[[nodiscard]] PointPair precondition(std::span<const Point> source, std::span<const Point> target);

} // namespace lichen::transport
