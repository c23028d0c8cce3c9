// SPDX-License-Identifier: MIT
// Exemplar -> the Gaussian image and inverse table of a tiling -> random phases -> decoded values.
#include "random_phase_version.h"

#include "evaluation/method_evaluator.h"

#include <lichen/gaussian_image.h>
#include <lichen/spectrum.h>
#include <lichen/tiling.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace lichen {

Result<LinearImage> randomPhaseVersion(const MapExemplar& exemplar, std::uint32_t seed) {
  TilingOptions options;
  options.bits = 16;
  Result<TilingBake> baked = bakeTiling("gaussian", std::span(&exemplar, 1), options);
  if (!baked)
    return baked.error();
  Bundle bundle;
  bundle.noises.push_back(std::move(baked.value().noise));
  bundle.tables = std::move(baked.value().tables);
  const auto& map = bundle.noises[0].maps[0].as<TilingMap>();
  const Table& image = bundle.tables[map.gaussian];
  const std::vector<float> texels = decodeLevel(image, 0);
  const auto stride = std::size_t(channelCount(image.format));
  std::vector<std::vector<float>> planes;
  for (std::size_t c = 0; c < std::size_t(map.dimensions); ++c) {
    std::vector<float> plane;
    for (std::size_t i = c; i < texels.size(); i += stride)
      plane.push_back(texels[i] + 0.5f - kStoredGaussianMean);
    planes.push_back(
        phaseRandomizedPlane(forwardFft(plane, int(image.width), int(image.height)), seed));
  }
  const auto evaluator = methodEvaluator(bundle, 0);
  const std::size_t channels = exemplar.channels.size();
  LinearImage result(int(image.width), int(image.height), int(channels));
  for (std::size_t i = 0; i < result.pixelCount(); ++i) {
    std::array<float, 3> gaussian{0.5f, 0.5f, 0.5f};
    for (std::size_t c = 0; c < planes.size(); ++c)
      gaussian[c] = planes[c][i];
    const std::array<float, 4> value = evaluator->decoded(0, gaussian);
    std::copy_n(value.begin(), channels, &result.values[channels * i]);
  }
  return result;
}

} // namespace lichen
