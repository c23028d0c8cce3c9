// SPDX-License-Identifier: MIT
// Reads the losses of a Gaussian image's mip levels.
#include <lichen/gaussian_image.h>

namespace lichen {

std::vector<float> fetchLosses(const Table& gaussian) {
  std::vector<float> losses;
  Table texel{{}, gaussian.format, 1, 1, 0, 1, {}};
  for (std::uint32_t mip = 0; mip < gaussian.mipLevels; ++mip) {
    const auto first = gaussian.texels.begin() + std::ptrdiff_t(levelRange(gaussian, mip).offset);
    texel.texels.assign(first, first + std::ptrdiff_t(texelBytes(gaussian.format)));
    losses.push_back(decodeLevel(texel, 0).back());
  }
  return losses;
}

} // namespace lichen
