// SPDX-License-Identifier: MIT
// The Gaussian of [HN18]: mean 1/2 and standard deviation 1/6 per channel, so that [0, 1] spans
// three deviations each way.
#pragma once

#include "transport/point.h"

#include <cstddef>
#include <vector>

namespace lichen::gaussian {

inline constexpr double kGaussianMean = 0.5;
inline constexpr double kGaussianDeviation = 1.0 / 6.0;

/// [HN18] eq. 22, corrected (docs/theory.md): U = 1/2 + erf(3 sqrt(2) (G - 1/2)) / 2.
[[nodiscard]] double gaussianCdf(double value);

/// Its inverse, [HN18] eq. 20 corrected; `u` in (0, 1). Relative error of the deviate 1e-7
/// [W88] PPND7.
[[nodiscard]] double gaussianQuantile(double u);

/// How the samples will be stored.
enum class Precision {
  bits8,  ///< clamped to [0, 1] and rounded to 1 / 255
  bits16, ///< as half floats: neither clamped nor rounded here
};

/// The points moved as little as possible so that, once stored, their mean is 1/2 and their
/// covariance I / 36: to float rounding for bits16, to what rounding each coordinate to 8 bits
/// leaves for bits8. Coordinates beyond `dimensions` become 0; directions without variance stay so.
[[nodiscard]] std::vector<Point> whitenedForStorage(const std::vector<Point>& points,
                                                    int dimensions, Precision precision);

/// `count` points of the `dimensions`-dimensional Gaussian (1 to 3; further coordinates 0),
/// stratified by a Hammersley set through the quantile, with mean and covariance exact: to float
/// rounding for bits16, to what rounding each coordinate to 8 bits leaves for bits8. Point i has
/// the i-th stratum of the first coordinate.
[[nodiscard]] std::vector<Point> stratifiedGaussian(std::size_t count, int dimensions,
                                                    Precision precision);

} // namespace lichen::gaussian
