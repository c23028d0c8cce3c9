// SPDX-License-Identifier: MIT
// The Gaussian of [HN18]: mean 1/2 and standard deviation 1/6 per channel, so that [0, 1] spans
// three standard deviations on each side of the mean.
#pragma once

#include "transport/point.h"

#include <cstddef>
#include <vector>

namespace lichen::gaussian {

inline constexpr double kGaussianMean = 0.5;
inline constexpr double kGaussianDeviation = 1.0 / 6.0;

/// [HN18] eq. 22, corrected (docs/theory.md): U = 1/2 + erf(3 sqrt(2) (G - 1/2)) / 2.
[[nodiscard]] double gaussianCdf(double value);

/// The inverse of gaussianCdf(), [HN18] eq. 20 corrected; `u` in (0, 1). Relative error of the
/// deviate: 1e-7 [W88] PPND7.
[[nodiscard]] double gaussianQuantile(double u);

/// The precision at which samples will be stored.
enum class Precision {
  bits8,  ///< rounded to multiples of 1 / 255 from the mean, of which there are 256
  bits16, ///< stored as half floats: neither clamped nor rounded here
};

/// Moves the points as little as possible so that, once stored, their mean is 1/2 and their
/// covariance is I / 36. For bits16 this holds to float rounding; for bits8, to what rounding each
/// coordinate to 8 bits leaves. Coordinates beyond `dimensions` become 0. Directions without
/// variance get none.
[[nodiscard]] std::vector<Point> whitenedForStorage(const std::vector<Point>& points,
                                                    int dimensions, Precision precision);

/// Returns `count` points of the `dimensions`-dimensional Gaussian (1 to 3; further coordinates are
/// 0). A Hammersley set mapped through the quantile stratifies them. Mean and covariance are exact:
/// for bits16 to float rounding, for bits8 to what rounding each coordinate to 8 bits leaves. Point
/// i has the i-th stratum of the first coordinate.
[[nodiscard]] std::vector<Point> stratifiedGaussian(std::size_t count, int dimensions,
                                                    Precision precision);

} // namespace lichen::gaussian
