// SPDX-License-Identifier: MIT
// Exemplar -> the Gaussian image and inverse table of a tiling -> random phases -> decoded values;
// result and exemplar -> measures; risks of textons -> the one that random phases have.
#include "random_phases.h"

#include "evaluation/method_evaluator.h"

#include <lichen/gaussian_image.h>
#include <lichen/spectrum.h>
#include <lichen/tiling.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace lichen {

Result<std::vector<Risk>> outlineRisks(const MapExemplar& map, const std::vector<BakeSetting>& more,
                                       const Progress& progress) {
  const int support = std::max(map.width, map.height); // nothing is slower than the tile
  Result<std::vector<Risk>> risks = assessTextonSuitability(map, support, progress);
  if (!risks)
    return risks;
  std::vector<Risk> kept;
  std::ranges::copy_if(risks.value(), std::back_inserter(kept),
                       [](const Risk& risk) { return risk.name == "outlines"; });
  for (Risk& risk : kept)
    if (risk.level != Risk::Level::none)
      risk.settings.insert(risk.settings.begin(), more.begin(), more.end());
  return kept;
}

Result<void> judgeRandomPhase(const ComparedResult& result, bool hasGivenSpectrum,
                              const GaussianTargets& targets, NoiseComparison& comparison) {
  if (!hasGivenSpectrum) {
    const Result<LinearImage> version =
        randomPhaseVersion(result.exemplar, result.options.material.seed);
    if (!version)
      return version.error();
    comparison.gaussian = comparison.look.picture(version.value());
  }
  if (Result<void> taken = take(
          comparison.gaussian ? measureGaussianResult(comparison.exemplar, *comparison.gaussian,
                                                      comparison.result, targets)
                              : measureResult(comparison.exemplar, comparison.result),
          comparison);
      !taken)
    return taken;
  if (hasGivenSpectrum)
    for (Measure& measure : comparison.measures)
      if (measure.name != kColorDistanceName && measure.target) {
        measure.target.reset();
        measure.remark = "no target: the noise has another spectrum on purpose";
      }
  return {};
}

Result<LinearImage> randomPhaseVersion(const MapExemplar& exemplar, std::uint32_t seed) {
  TilingOptions options;
  options.bits = 16;
  Result<MethodBake> baked = bakeTiling("gaussian", std::span(&exemplar, 1), options);
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
