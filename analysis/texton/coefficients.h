// SPDX-License-Identifier: MIT
// What coefficients of a texton stand for: their interpolation by B-splines, the covariance between
// the channels of their noise, and how much the magnitudes of their texels differ.
#pragma once

#include "fit.h"

#include <lichen/exemplar.h>

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::texton {

/// Returns the sum over k, l of b(k - l) alpha(k) alpha(l)^T, channels x channels: the covariance
/// between the channels of the noise at one point [GLM17 section 4.3].
[[nodiscard]] Eigen::MatrixXd noiseCovariance(const TextonCoefficients& coefficients, int order);

/// Multiplies the coefficients of every texel by the transport map from their noise's covariance to
/// `target`, then repeats this to remove rounding errors. The map is symmetric when each channel is
/// measured in its standard deviations. The error of every entry C_ij is at most 1e-6 sqrt(C_ii
/// C_jj), before any rounding to half floats.
/// Combinations of channels in which the texton does not vary are ignored if the target is below a
/// thousandth there, in the same measure. If it is above, no linear map can help: returns false and
/// changes nothing. Rank-deficient covariances, as of grey stored as RGB, are usual.
[[nodiscard]] bool correctCovariance(TextonCoefficients& coefficients, int order,
                                     const Eigen::MatrixXd& target);

/// Returns b_j, j = 0 .. order: the B-spline of degree 2 order + 1 at the integers, which is the
/// autocorrelation of the interpolation kernel of that order. b_-j = b_j, and the sum over all j is
/// 1. order in [0, 8]. Source: [GLM17] section 4.1; [UAE93].
[[nodiscard]] std::vector<double> kernelAutocorrelation(int order);

/// Returns b^(x), the Fourier series of b at x cycles per texel, > 0. For order 1 it is (2 + cos 2
/// pi x) / 3.
[[nodiscard]] double kernelPower(int order, double cyclesPerTexel);

/// Returns sqrt(b^) at the `size` frequencies of a row of `size` texels.
[[nodiscard]] std::vector<float> kernelAmplitudes(int order, int size);

/// Returns r^2 sum l^4 / (sum l^2)^2 over the r^2 pixels of the support, where l is the sum of the
/// channels with `weights`, one per channel. The value is 1 for a spot of constant magnitude, 3 for
/// normally distributed values, r^2 for a spot of one pixel and 0 for a spot of zeros.
[[nodiscard]] double flatness(const TextonCoefficients& spot, std::span<const float> weights);

/// Returns the interpolated texton at and around its coefficients. Up to order 1 these are the
/// coefficients; for order 3 they are the cubic B-spline, whose coefficients may be far larger than
/// its values.
[[nodiscard]] TextonCoefficients interpolatedSpot(const TextonCoefficients& coefficients,
                                                  int order);

/// Weights that approximate how the eye sees these channels: luminance weights for colours, else 1
/// each.
[[nodiscard]] std::vector<float> seenWeights(std::span<const MapChannel> channels);

} // namespace lichen::texton
