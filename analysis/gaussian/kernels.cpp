// SPDX-License-Identifier: MIT
// Gaussian model (spectra of height x width) -> spots (channels, height, width of the support).
//
// Sources: [GLM14] section 4, [DMR12], [GGM11].
#include "kernels.h"

#include <lichen/spectrum.h>

#include <cassert>
#include <cmath>

namespace lichen::gaussian {
namespace {

/// Appends `scale` times a window, starting at (left, top), of a periodic plane of the model's
/// size.
void appendWindow(const std::vector<float>& plane, const GaussianModel& model, int left, int top,
                  float scale, Spot& kernel) {
  assert(kernel.width >= 1 && kernel.width <= model.width());
  assert(kernel.height >= 1 && kernel.height <= model.height());
  for (int y = 0; y < kernel.height; ++y) {
    for (int x = 0; x < kernel.width; ++x) {
      const int fromX = (left + x + model.width()) % model.width();
      const int fromY = (top + y + model.height()) % model.height();
      kernel.values.push_back(
          scale * plane[std::size_t(fromY) * std::size_t(model.width()) + std::size_t(fromX)]);
    }
  }
}

Spot emptyKernel(const GaussianModel& model, int width, int height) {
  return {width, height, int(model.channels.size()), {}};
}

/// Returns the scale that makes the variance of a part's noise, averaged over all parts, equal to
/// the variance of the whole.
float partScale(const GaussianModel& model, int width, int height) {
  return std::sqrt(float(model.width()) / float(width) * float(model.height()) / float(height));
}

} // namespace

Spot exemplarKernel(const GaussianModel& model, int width, int height) {
  Spot kernel = emptyKernel(model, width, height);
  const float scale = partScale(model, width, height);
  for (const HalfSpectrum& channel : model.channels)
    appendWindow(inverseFft(channel), model, 0, 0, scale, kernel);
  return kernel;
}

Spot luminanceTexton(const GaussianModel& model, int width, int height) {
  std::vector<std::complex<float>> phases(model.channels[0].values.size(), 0.0f);
  for (const HalfSpectrum& channel : model.channels)
    for (std::size_t i = 0; i < phases.size(); ++i)
      phases[i] += channel.values[i];
  for (std::complex<float>& phase : phases) {
    const float modulus = std::abs(phase);
    phase = modulus > 0.0f ? phase / modulus : 1.0f;
  }
  Spot kernel = emptyKernel(model, width, height);
  for (HalfSpectrum channel : model.channels) {
    for (std::size_t i = 0; i < phases.size(); ++i)
      channel.values[i] *= std::conj(phases[i]);
    appendWindow(inverseFft(channel), model, -(width / 2), -(height / 2), 1.0f, kernel);
  }
  return kernel;
}

Spot randomPhaseKernel(const GaussianModel& model, int width, int height, std::uint32_t seed) {
  Spot kernel = emptyKernel(model, width, height);
  const float scale = partScale(model, width, height);
  for (const HalfSpectrum& channel : model.channels)
    appendWindow(phaseRandomizedPlane(channel, seed), model, 0, 0, scale, kernel);
  return kernel;
}

} // namespace lichen::gaussian
