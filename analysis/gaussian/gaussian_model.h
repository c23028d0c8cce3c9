// SPDX-License-Identifier: MIT
// The Gaussian texture of an exemplar: its spectrum with random phases.
#pragma once

#include <lichen/fft.h>

#include <span>
#include <vector>

namespace lichen::gaussian {

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

} // namespace lichen::gaussian
