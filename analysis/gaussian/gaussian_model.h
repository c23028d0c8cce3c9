// SPDX-License-Identifier: MIT
// The Gaussian texture of an exemplar: the one with its spectrum and random phases.
#pragma once

#include <lichen/fft.h>

#include <span>
#include <vector>

namespace lichen::gaussian {

/// A Gaussian texture of `channels` channels on a periodic domain: white noise convolved with one
/// kernel a channel. channels[c] is the kernel's transform, t_u^ of [GLM17] section 3.1 for an
/// exemplar: all of one size, at least 1, and zero at frequency 0.
struct GaussianModel {
  std::vector<HalfSpectrum> channels;

  [[nodiscard]] int width() const { return channels[0].width; }
  [[nodiscard]] int height() const { return channels[0].height; }
};

/// The model of an image, `channelCount` interleaved values a pixel: the periodic component less
/// its mean over sqrt(width height) [GLM17] section 3.1, [M11].
[[nodiscard]] GaussianModel gaussianModel(std::span<const float> values, int width, int height,
                                          int channelCount);

} // namespace lichen::gaussian
