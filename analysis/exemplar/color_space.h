// SPDX-License-Identifier: MIT
// The affine space spanned by an exemplar's values.
#pragma once

#include "transport/covariance.h"
#include "transport/point.h"

#include <lichen/exemplar.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace lichen::exemplar {

/// Vectors and matrices over the channels of one map, stored on the stack.
inline constexpr int kMaxChannels = 3;
using ChannelVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxChannels, 1>;
using ChannelMatrix = transport::SmallMatrix;

/// Mean and covariance of interleaved values; `values.size()` is a multiple of `channels` (1 to 3).
using Moments = transport::Moments<ChannelMatrix>;
[[nodiscard]] Moments momentsOf(std::span<const float> values, int channels);

/// The least and the greatest value of one channel of interleaved values.
struct ValueRange {
  float least = 0.0f, most = 0.0f;
};
[[nodiscard]] ValueRange rangeOf(std::span<const float> values, std::size_t channels,
                                 std::size_t channel);

/// Coordinates of the exemplar's values in `dimensions` (0 to channels) orthonormal directions, the
/// rows of `basis`. These are the directions whose variance is more than twice the variance of
/// rounding the stored values (quantum^2 / 12). A grey photograph stored as RGB has 1, a constant
/// image 0. If all channels vary, the basis is the identity, so that each Gaussian channel belongs
/// to one colour.
struct ColorSpace {
  Moments moments;
  ChannelMatrix basis;
  [[nodiscard]] int dimensions() const { return int(basis.rows()); }
  /// Square root of the total variance over all directions.
  [[nodiscard]] double deviation() const {
    return std::sqrt((basis * moments.covariance * basis.transpose()).trace());
  }
};
[[nodiscard]] ColorSpace colorSpaceOf(const MapExemplar& map);

/// Projects the map on the eigenvector of its covariance with the largest eigenvalue: one channel.
/// Throws std::bad_alloc.
[[nodiscard]] MapExemplar principalComponent(const MapExemplar& map);

/// The middle of the best values for photographs: docs/decisions/004-transport.md.
inline constexpr float kUsualShare = 0.1f;

/// Projects (value - mean) on the basis, as points for the transport. Ties are broken: the average
/// of their surroundings, at most half a quantum, orders pixels of equal value, so that flat
/// regions stay smooth after Gaussianization. In two and three dimensions each point includes
/// `share` of its surroundings: a positive share makes G smoother, a negative one rougher
/// (docs/decisions/004-transport.md). The image wraps at its borders.
[[nodiscard]] std::vector<Point> transportPoints(const MapExemplar& map, const ColorSpace& space,
                                                 float share = kUsualShare);

} // namespace lichen::exemplar
