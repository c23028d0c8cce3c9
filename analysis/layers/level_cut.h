// SPDX-License-Identifier: MIT
// Where a Gaussian field exceeds a threshold: the covariance of the field and the covariance of the
// indicator.
#pragma once

#include <vector>

namespace lichen::layers {

/// The indicator of a standard normal field that is above a threshold with probability
/// `proportion`.
class LevelCut {
public:
  /// `proportion` in (0, 1). Throws std::bad_alloc.
  explicit LevelCut(double proportion);

  /// The covariance of the indicator at two points whose field values have the correlation
  /// `correlation`, in [-1, 1].
  [[nodiscard]] double covariance(double correlation) const;

  /// The derivative of covariance().
  [[nodiscard]] double slope(double correlation) const;

  /// The inverse of covariance(). Covariances beyond its range give -1 or 1.
  [[nodiscard]] double correlation(double covariance) const;

private:
  double threshold_;
  std::vector<double> covariances_; ///< at arc sines from -pi / 2 to pi / 2
};

} // namespace lichen::layers
