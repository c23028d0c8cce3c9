// SPDX-License-Identifier: MIT
// Makes two point sets alike before they are matched, without changing the optimal matching.
#pragma once

#include "point.h"

#include <span>
#include <vector>

namespace lichen::transport {

/// Two centred sets with the same covariance (on the range that both span).
struct PointPair {
  std::vector<Point> source;
  std::vector<Point> target;
  int dimensions = 3; ///< of the range that both span, 0 to 3
};

/// X' = M^(1/2) (X - E X), Y' = M^(-1/2) (Y - E Y), with M the symmetric map that carries the
/// covariance A of X to the covariance B of Y, M = A^(-1/2) (A^(1/2) B A^(1/2))^(1/2) A^(-1/2)
/// [PC19] eq. 2.40. A bijection that minimises sum |x - y|^2 maximises
/// sum <x, y> = sum <X', Y'> + const, so both problems have the same solutions, but here the
/// solution is close to the identity, which is what partitions find well.
/// Directions in which X does not vary do not count, and are set to 0 in X' and Y'.
[[nodiscard]] PointPair precondition(std::span<const Point> source, std::span<const Point> target);

} // namespace lichen::transport
