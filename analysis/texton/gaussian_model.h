// SPDX-License-Identifier: MIT
// The Gaussian texture of an exemplar, its spectrum with random phases, and the distance between
// two Gaussian textures.
#pragma once

#include <lichen/fft.h>

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace lichen::texton {

/// A Gaussian texture on a periodic domain: white noise convolved with one kernel per channel.
/// channels[c] is the kernel's transform, for an exemplar t_u^ of [GLM17] section 3.1. All have one
/// size, at least 1, and are zero at frequency 0.
struct GaussianModel {
  std::vector<HalfSpectrum> channels;

  [[nodiscard]] int width() const { return channels[0].width; }
  [[nodiscard]] int height() const { return channels[0].height; }
};

/// Returns the model of an image with `channelCount` interleaved values per pixel: the transform of
/// (the periodic component minus its mean) / sqrt(width height) [GLM17] section 3.1, [M11].
[[nodiscard]] GaussianModel gaussianModel(std::span<const float> values, int width, int height,
                                          int channelCount);

/// Returns the covariance at one point, channels x channels: the mean of the cross-spectra over all
/// frequencies.
[[nodiscard]] Eigen::MatrixXd modelCovariance(const GaussianModel& model);

/// Returns whether a model of covariance `model` varies along every direction in which the noise
/// must vary. A pure brightness gradient leaves only rounding in the model, and no gain turns that
/// into a texture.
[[nodiscard]] bool isModelled(const Eigen::MatrixXd& model, const Eigen::MatrixXd& wanted);

/// The B-spline coefficients of a texton, `width` x `height` per channel: (x, y, c) is at
/// (c * height + y) * width + x.
struct TextonCoefficients {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;
};

/// Returns the transform of a channel's coefficients in a plane of zeros of width x height, at
/// least as large.
[[nodiscard]] HalfSpectrum channelSpectrum(const TextonCoefficients& coefficients,
                                           std::size_t channel, int width, int height);

/// Returns the Gaussian texture that the noise of a texton of this order converges to, on a torus
/// at least as large as the texton: h^ = sqrt(b^) alpha^, [GLM17] eq. 4. Frequency 0 is zero, as in
/// every model.
[[nodiscard]] GaussianModel noiseModel(const TextonCoefficients& coefficients, int order, int width,
                                       int height);

/// Returns the variance of a pixel, summed over the channels.
[[nodiscard]] double modelVariance(const GaussianModel& model);

/// [GLM14] eq. 1: the squared L2 optimal transport distance between two Gaussian textures of one
/// size and number of channels, divided by the number of pixels. It is 0 where power spectra and
/// cross-spectra are equal, and at most the sum of the two variances. On any smaller domain the
/// distance between the textures is not larger (section 2.3).
[[nodiscard]] double squaredTransportDistance(const GaussianModel& a, const GaussianModel& b);

} // namespace lichen::texton
