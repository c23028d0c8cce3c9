// SPDX-License-Identifier: MIT
// Gaussian model (spectra of height x width) and domain -> a realization (channels, height, width).
//
// Any kernel with the model's spectra gives the right noise on the model's torus. The luminance
// texton has the least energy far from its centre, so it loses least where the domain does not
// wrap.
// Sources: [GLM14] section 2.4, [GGM11].
#include "gaussian_texture.h"

#include "kernels.h"

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

NoisePlanes gaussianTexture(const GaussianModel& model, const PixelDomain& domain,
                            std::uint64_t seed) {
  const Spot kernel = luminanceTexton(model, model.width(), model.height());
  const bool part =
      !domain.periodic && domain.width <= model.width() && domain.height <= model.height();
  if (!part)
    return gaussianSpotNoise(kernel, domain, seed);
  const PixelDomain torus{domain.x, domain.y, model.width(), model.height(), true};
  return cropped(gaussianSpotNoise(kernel, torus, seed), domain.width, domain.height);
}

} // namespace lichen::gaussian
