// SPDX-License-Identifier: MIT
// A texton noise and its exemplar -> measures against the exemplar's Gaussian texture, which is the
// limit of texton noise.
#include "../method_report.h"

#include <lichen/texton.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

constexpr GaussianTargets kTargets{0.5, 0.5, false};

Measure flatnessMeasure(const TextonJudgement& texton) {
  return {
      "flatness",
      "",
      "how much the magnitudes of the texton's texels differ; ten times as many impacts are enough",
      texton.flatness,
      kFlatnessTarget,
      {}};
}

Measure modelErrorMeasure(const TextonJudgement& texton) {
  return {"model_error",
          "",
          "transport distance of all channels together to the exemplar's Gaussian texture, as a "
          "share of its deviation",
          texton.modelError,
          {},
          {}};
}

/// The step of a mix that is nearest to a weight.
std::size_t stepAt(const Noise& noise, double weight) {
  return std::size_t(std::lround(weight * double(noise.as<TextonShape>().steps - 1)));
}

/// A map at one step of a mix.
NoiseMap mapAt(const NoiseMap& map, std::size_t step) {
  NoiseMap here = map;
  if (step > 0) {
    const TextonStep& later = map.as<TextonMap>().laterSteps[step - 1];
    here.mean = later.mean;
    here.covariance = later.covariance;
  }
  return here;
}

Result<std::vector<Risk>> assess(const AssessedMap& assessed, const Progress& progress) {
  const auto& shape = assessed.noise.as<TextonShape>();
  const int support = std::min(shape.coefficientsX, shape.coefficientsY) + shape.order;
  return assessTextonSuitability(assessed.map(), support, progress, shape.texelsPerTileX,
                                 shape.texelsPerTileY);
}

Result<void> measure(const ComparedResult& result, NoiseComparison& comparison) {
  const SynthesisOptions& options = result.options;
  const std::size_t step = stepAt(result.bundle.noises[options.material.noise], options.mix[0]);
  const Result<MapExemplar> gaussian =
      gaussianVersion(mapAt(result.map, step), result.exemplar, options.material.seed);
  if (!gaussian)
    return gaussian.error();
  comparison.gaussian = comparison.look.picture(gaussian.value());
  Result<std::vector<Measure>> measures =
      measureGaussianResult(comparison.exemplar, *comparison.gaussian, comparison.result, kTargets);
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  if (result.isEnlarged)
    for (Measure& measure : comparison.measures)
      if (measure.name == kGaussianSpectrumDistanceName && measure.value) {
        measure.target.reset();
        measure.remark = "no target: the map was enlarged to the size of the largest, so it "
                         "has no finest detail to compare";
      }
  return {};
}

Result<void> judge(const ComparedResult& result, NoiseComparison& comparison) {
  const Bundle& bundle = result.bundle;
  const SynthesisOptions& options = result.options;
  const std::size_t step = stepAt(bundle.noises[options.material.noise], options.mix[0]);
  const Result<TextonJudgement> texton =
      judgeTexton(bundle, options.material.noise, result.exemplar, step);
  if (!texton)
    return texton.error();
  comparison.measures.push_back(modelErrorMeasure(texton.value()));
  comparison.measures.push_back(flatnessMeasure(texton.value()));
  return {};
}

} // namespace

/// The same pictures as for tiling, and a Gaussian version as large as the result.
extern const MethodReport kTextonReport{.assess = assess,
                                        .measure = measure,
                                        .judge = judge,
                                        .picturePixels = 11.0,
                                        .enlargesMaps = true};

} // namespace lichen
