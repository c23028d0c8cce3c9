// SPDX-License-Identifier: MIT
// Bundle and exemplar -> pictures of both and the measures between them.
#include "exemplar/resample.h"

#include <lichen/noise_comparison.h>
#include <lichen/synthesize.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

constexpr int kResultExemplars = 4; // a side
/// A result of 4096 x 4096 RGB takes 200 MB; more pixels tell no more.
constexpr int kLargestSide = 4096;

/// Of the exemplar, in texels.
struct Extents {
  int width = 0;
  int height = 0;
};

/// The exemplars that the lattice is looked for in. Of large ones not every texel is evaluated;
/// those that are keep their footprint, since a coarser one would show another noise, whose
/// averaged texels are less Gaussian: its contrast follows the lattice three times as much.
SynthesisOptions latticeOptions(SynthesisOptions options, const Extents& exemplar) {
  const int width = kLatticeExemplars * exemplar.width;
  const int height = kLatticeExemplars * exemplar.height;
  options.stride = (std::max(width, height) + kLargestSide - 1) / kLargestSide;
  options.width = std::max(1, width / options.stride);
  options.height = std::max(1, height / options.stride);
  return options;
}

LatticeView latticeView(const SynthesisOptions& options, const Extents& exemplar) {
  const double stride = options.stride;
  const double firstTexel = 0.5 - 0.5 * stride; // a view's pixels have their centres in the middle
  return {{},
          stride / exemplar.width,
          stride / exemplar.height,
          firstTexel / exemplar.width,
          firstTexel / exemplar.height};
}

std::string listOf(const std::vector<MapChannel>& channels) {
  std::string list;
  for (const MapChannel channel : channels)
    list += (list.empty() ? "" : ", ") + std::string(nameOf(channel));
  return list;
}

/// The noise's map that the exemplar is of.
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

/// How far the noise shows the lattice of its tiles.
Result<Measure> latticeMeasure(const Bundle& bundle, const SynthesisOptions& wide,
                               const Extents& exemplar, const MapLook& look) {
  const Result<LinearImage> result = synthesize(bundle, wide);
  if (!result)
    return result.error();
  return measureLattice(look.picture(result.value()), latticeView(wide, exemplar));
}

Measure flatnessMeasure(const KernelComparison& kernels) {
  return {"flatness",
          "",
          "how unlike the magnitudes of the texton's texels are; a tenth of the impacts it takes",
          kernels.texton.flatness,
          kFlatnessTarget,
          {}};
}

Measure modelErrorMeasure(const KernelComparison& kernels) {
  return {"model_error",
          "",
          "transport distance to the exemplar's Gaussian texture, as a share of its deviation",
          kernels.texton.modelError,
          {},
          {}};
}

/// The step of a mix at a weight; 0 of other noises.
std::size_t stepAt(const Noise& noise, double weight) {
  return std::size_t(std::lround(weight * double(noise.texton.steps - 1)));
}

/// A map as it is at a step of a mix.
NoiseMap mapAt(const NoiseMap& map, std::size_t step) {
  NoiseMap here = map;
  if (step > 0) {
    here.mean = map.laterSteps[step - 1].mean;
    here.covariance = map.laterSteps[step - 1].covariance;
  }
  return here;
}

/// Measures of a texton's result, for which the exemplar's Gaussian texture counts.
Result<void> judgeAsGaussian(const Bundle& bundle, const SynthesisOptions& options,
                             const NoiseMap& map, const MapExemplar& exemplar, bool isEnlarged,
                             NoiseComparison& comparison) {
  const std::size_t step = stepAt(bundle.noises[options.material.noise], options.mix[0]);
  const Result<MapExemplar> gaussian =
      gaussianVersion(mapAt(map, step), exemplar, options.material.seed);
  if (!gaussian)
    return gaussian.error();
  comparison.gaussian = comparison.look.picture(gaussian.value());
  const Result<KernelComparison> kernels =
      compareTexton(bundle, options.material.noise, exemplar, step);
  if (!kernels)
    return kernels.error();
  comparison.kernels = kernels.value();
  Result<std::vector<Measure>> measures =
      measureGaussianResult(comparison.exemplar, *comparison.gaussian, comparison.result);
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  if (isEnlarged)
    for (Measure& measure : comparison.measures)
      if (measure.name == kGaussianSpectrumDistanceName && measure.value) {
        measure.target.reset();
        measure.remark = "no target: the map was enlarged to the size of the largest, and has "
                         "nothing to compare in the finest waves";
      }
  comparison.measures.push_back(modelErrorMeasure(kernels.value()));
  comparison.measures.push_back(flatnessMeasure(kernels.value()));
  return {};
}

Result<NoiseComparison> compare(const Bundle& bundle, const NoiseMap& map, const MapExemplar& given,
                                const MaterialNoise& material, const Progress& progress) {
  const Noise& noise = bundle.noises[material.noise];
  const auto [width, height] = exemplarSize(bundle, noise, map);
  const Extents baked{int(width), int(height)};
  // Textons of smaller maps of a set are of the size of the largest.
  std::optional<MapExemplar> enlarged;
  if (noise.method == Method::texton &&
      (given.width != baked.width || given.height != baked.height))
    enlarged = exemplar::resampled(given, baked.width, baked.height, false);
  const MapExemplar& exemplar = enlarged ? *enlarged : given;
  const bool hasLattice = noise.method == Method::tiling;
  SynthesisOptions options;
  options.material = material;
  options.map = map.target;
  if (material.mix.source == MixSource::constant)
    options.mix = {material.mix.weight, material.mix.weight};
  options.width = std::min(kResultExemplars * baked.width, kLargestSide);
  options.height = std::min(kResultExemplars * baked.height, kLargestSide);
  SynthesisOptions wide = latticeOptions(options, baked);
  // The result's progress and the lattice's are by the pixels of each.
  const double resultPixels = double(options.width) * options.height;
  const double widePixels = hasLattice ? double(wide.width) * wide.height : 0.0;
  const double share = resultPixels / (resultPixels + widePixels);
  options.progress = partOf(progress, 0.0, share);
  wide.progress = partOf(progress, share, 1.0);

  const Result<LinearImage> result = synthesize(bundle, options);
  if (!result)
    return result.error();
  const MapLook look(exemplar, map.encoding);
  NoiseComparison comparison{look, look.picture(exemplar), look.picture(result.value()), {}, {},
                             {}};
  if (noise.method == Method::texton) {
    if (Result<void> judged =
            judgeAsGaussian(bundle, options, map, exemplar, enlarged.has_value(), comparison);
        !judged)
      return judged.error();
    return comparison;
  }
  Result<std::vector<Measure>> measures = measureResult(comparison.exemplar, comparison.result);
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  Result<Measure> lattice = latticeMeasure(bundle, wide, baked, look);
  if (!lattice)
    return lattice.error();
  comparison.measures.push_back(std::move(lattice).value());
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

} // namespace lichen
