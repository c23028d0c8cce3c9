// SPDX-License-Identifier: MIT
// Image (height, width, channels) -> the transforms of the kernels of its Gaussian texture.
//
// Sources: [GLM17] sections 3.1 and 4.2; [M11].
#include "gaussian_model.h"

#include <lichen/spectrum.h>

#include <cassert>
#include <cmath>

namespace lichen::gaussian {

GaussianModel gaussianModel(std::span<const float> values, int width, int height,
                            int channelCount) {
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  const auto channels = std::size_t(channelCount);
  assert(width >= 1 && height >= 1 && values.size() == pixels * channels);
  const float scale = 1.0f / std::sqrt(float(pixels));
  GaussianModel model;
  std::vector<float> plane(pixels);
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < pixels; ++i)
      plane[i] = values[i * channels + c] * scale;
    model.channels.push_back(forwardFft(periodicComponent(plane, width, height), width, height));
    model.channels.back().values[0] = 0.0f; // removes the mean
  }
  return model;
}

} // namespace lichen::gaussian
