// SPDX-License-Identifier: MIT
// A texton noise and its exemplar -> measures against the exemplar's Gaussian texture, which is the
// limit of texton noise.
#include "../method_report.h"
#include "texton/judgement.h"

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

constexpr GaussianTargets kTargets{0.5, 0.5, false};

Measure flatnessMeasure(double flatness) {
  return {
      "flatness",
      "",
      "how much the magnitudes of the texton's texels differ; ten times as many impacts are enough",
      flatness,
      kFlatnessTarget,
      {}};
}

Measure modelErrorMeasure(double error) {
  return {"model_error",
          "",
          "transport distance of all channels together to the exemplar's Gaussian texture, as a "
          "share of its deviation",
          error,
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
  comparison.gaussian = comparison.look.picture(
      texton::gaussianVersion(mapAt(result.map, step), result.exemplar, options.material.seed));
  if (Result<void> taken = take(measureGaussianResult(comparison.exemplar, *comparison.gaussian,
                                                      comparison.result, kTargets),
                                comparison);
      !taken)
    return taken;
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
  const Noise& noise = result.bundle.noises[result.options.material.noise];
  const texton::TextonJudgement judged = texton::judgeTexton(
      result.bundle, noise, result.map, result.exemplar, stepAt(noise, result.options.mix[0]));
  comparison.measures.push_back(modelErrorMeasure(judged.modelError));
  comparison.measures.push_back(flatnessMeasure(judged.flatness));
  return {};
}

} // namespace

extern const MethodReport kTextonReport{
    .assess = assess, .measure = measure, .judge = judge, .enlargesMaps = true};

} // namespace lichen
