// SPDX-License-Identifier: MIT
// The affine space that an exemplar's values span.
#pragma once

#include "transport/covariance_map.h"
#include "transport/point.h"

#include <lichen/exemplar.h>

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace lichen::exemplar {

/// Vectors and matrices over the channels of one map, on the stack.
inline constexpr int kMaxChannels = 3;
using ChannelVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxChannels, 1>;
using ChannelMatrix = transport::SmallMatrix;

/// Mean and covariance of interleaved values; `values.size()` is a multiple of `channels` (1 to 3).
struct Moments {
  ChannelVector mean;
  ChannelMatrix covariance;
};
[[nodiscard]] Moments momentsOf(std::span<const float> values, int channels);

/// Coordinates of the exemplar's values in `dimensions` (0 to channels) orthonormal directions, the
/// rows of `basis`: the directions whose variance is more than twice that of rounding the stored
/// values (quantum^2 / 12). A grey photograph stored as RGB has 1, a constant image 0. With all
/// channels varying the basis is the identity, so that each Gaussian channel goes with its colour.
struct ColorSpace {
  Moments moments;
  ChannelMatrix basis;
  [[nodiscard]] int dimensions() const { return int(basis.rows()); }
  /// Root of the variance of all directions together.
  [[nodiscard]] double deviation() const {
    return std::sqrt((basis * moments.covariance * basis.transpose()).trace());
  }
};
[[nodiscard]] ColorSpace colorSpaceOf(const MapExemplar& map);
/// As colorSpaceOf(), but the directions are always the principal ones, the largest variance first:
/// coordinates are uncorrelated.
[[nodiscard]] ColorSpace principalSpaceOf(const MapExemplar& map);

/// In the middle of photographs' choices: docs/decisions/009-surroundings.md.
inline constexpr float kUsualShare = 0.1f;

/// (value - mean) projected on the basis, as points for the transport, with ties broken: pixels of
/// equal value are ordered by the average of their surroundings, at most half a quantum, so that
/// flat regions stay smooth once Gaussianized. In two and three dimensions a point has `share` of
/// its surroundings, which makes G smoother, or of the opposite sign, which makes it rougher
/// (docs/decisions/009-surroundings.md). The image wraps at its borders.
[[nodiscard]] std::vector<Point> transportPoints(const MapExemplar& map, const ColorSpace& space,
                                                 float share = kUsualShare);

} // namespace lichen::exemplar
