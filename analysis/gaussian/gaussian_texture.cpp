// SPDX-License-Identifier: MIT
// Gaussian model (spectra of height x width) and domain -> a realization (channels, height, width).
//
// Any kernel with the model's spectra gives the right noise on the model's torus. The luminance
// texton has the least energy far from its centre, so it loses least where the domain does not
// wrap.
// Sources: [GLM14] sections 2.4 and 4, [DMR12], [GGM11].
#include "gaussian_texture.h"

#include <algorithm>

namespace lichen::gaussian {
namespace {

/// Returns the first `width` columns and `height` rows.
NoisePlanes cropped(const NoisePlanes& noise, int width, int height) {
  NoisePlanes crop{width, height, noise.channels, {}};
  for (int c = 0; c < noise.channels; ++c) {
    for (int y = 0; y < height; ++y) {
      const auto row = noise.values.begin() + (std::ptrdiff_t(c) * noise.height + y) * noise.width;
      crop.values.insert(crop.values.end(), row, row + width);
    }
  }
  return crop;
}

} // namespace

Spot luminanceTexton(const GaussianModel& model) {
  std::vector<std::complex<float>> phases(model.channels[0].values.size(), 0.0f);
  for (const HalfSpectrum& channel : model.channels)
    for (std::size_t i = 0; i < phases.size(); ++i)
      phases[i] += channel.values[i];
  for (std::complex<float>& phase : phases) {
    const float modulus = std::abs(phase);
    phase = modulus > 0.0f ? phase / modulus : 1.0f;
  }
  const int width = model.width(), height = model.height();
  Spot kernel{width, height, int(model.channels.size()), {}};
  for (HalfSpectrum channel : model.channels) {
    for (std::size_t i = 0; i < phases.size(); ++i)
      channel.values[i] *= std::conj(phases[i]);
    const std::vector<float> plane = inverseFft(channel);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        kernel.values.push_back(plane[std::size_t((y + height - height / 2) % height * width +
                                                  (x + width - width / 2) % width)]);
  }
  return kernel;
}

NoisePlanes gaussianTexture(const GaussianModel& model, const PixelDomain& domain,
                            std::uint64_t seed) {
  const Spot kernel = luminanceTexton(model);
  const bool part =
      !domain.periodic && domain.width <= model.width() && domain.height <= model.height();
  if (!part)
    return gaussianSpotNoise(kernel, domain, seed);
  const PixelDomain torus{domain.x, domain.y, model.width(), model.height(), true};
  return cropped(gaussianSpotNoise(kernel, torus, seed), domain.width, domain.height);
}

} // namespace lichen::gaussian
