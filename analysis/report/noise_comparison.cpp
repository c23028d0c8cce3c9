// SPDX-License-Identifier: MIT
// Bundle and exemplar -> pictures of both and the measures between them.
#include "exemplar/resample.h"
#include "method_report.h"

#include <lichen/noise_comparison.h>

#include <algorithm>

namespace lichen {
namespace {

constexpr int kResultExemplars = 4; // per side

std::string listOf(const std::vector<MapChannel>& channels) {
  std::string list;
  for (const MapChannel channel : channels)
    list += (list.empty() ? "" : ", ") + std::string(nameOf(channel));
  return list;
}

/// The noise's map with the exemplar's target.
Result<const NoiseMap*> mapOf(const Bundle& bundle, std::size_t noise,
                              const MapExemplar& exemplar) {
  if (noise >= bundle.noises.size())
    return Error{ErrorKind::usage, "noise " + std::to_string(noise) + ": the bundle has " +
                                       std::to_string(bundle.noises.size())};
  const std::optional<std::size_t> place = findMap(bundle.noises[noise], exemplar.target);
  if (!place)
    return Error{ErrorKind::usage, "noise '" + bundle.noises[noise].name + "' has no map " +
                                       std::string(nameOf(exemplar.target))};
  const NoiseMap& map = bundle.noises[noise].maps[*place];
  if (map.channels != exemplar.channels)
    return Error{ErrorKind::badInput, "the map " + std::string(nameOf(map.target)) + " of noise '" +
                                          bundle.noises[noise].name + "' has the channels " +
                                          listOf(map.channels) + "; the exemplar has " +
                                          listOf(exemplar.channels)};
  return &map;
}

Result<NoiseComparison> compare(const Bundle& bundle, const NoiseMap& map, const MapExemplar& given,
                                const MaterialNoise& material, const Progress& progress) {
  const Noise& noise = bundle.noises[material.noise];
  const MethodReport& method = reportOf(noise.method());
  const auto [bakedWidth, bakedHeight] = exemplarSize(bundle, noise, map);
  const int width = int(bakedWidth), height = int(bakedHeight);
  std::optional<MapExemplar> enlarged;
  if (method.enlargesMaps() && (given.width != width || given.height != height))
    enlarged = exemplar::resampled(given, width, height, false);
  const MapExemplar& exemplar = enlarged ? *enlarged : given;
  SynthesisOptions options;
  options.material = material;
  options.map = map.target;
  if (material.mix.source == MixSource::constant)
    options.mix = {material.mix.weight, material.mix.weight};
  options.width = std::min(kResultExemplars * width, kLargestResultSide);
  options.height = std::min(kResultExemplars * height, kLargestResultSide);
  const double pixels = double(options.width) * options.height;
  const double share = pixels / (pixels + method.judgedPixels(width, height));
  options.progress = partOf(progress, 0.0, share);
  const Result<LinearImage> result = synthesize(bundle, options);
  if (!result)
    return result.error();
  const MapLook look(exemplar, map.encoding);
  NoiseComparison comparison{look, look.picture(exemplar), look.picture(result.value()), {}, {},
                             {}};
  const ComparedResult compared{
      bundle, map, exemplar, enlarged.has_value(), options, partOf(progress, share, 1.0)};
  if (Result<void> judged = method.judge(compared, comparison); !judged)
    return judged.error();
  return comparison;
}

} // namespace

Result<NoiseComparison> compareNoise(const Bundle& bundle, const MaterialNoise& material,
                                     const MapExemplar& exemplar, const Progress& progress) {
  return withinMemory([] { return "not enough memory to compare the noise with its exemplar"; },
                      [&]() -> Result<NoiseComparison> {
                        const Result<const NoiseMap*> map = mapOf(bundle, material.noise, exemplar);
                        if (!map)
                          return map.error();
                        return compare(bundle, *map.value(), exemplar, material, progress);
                      });
}

bool enlargesMaps(Method method) { return reportOf(method).enlargesMaps(); }

} // namespace lichen
