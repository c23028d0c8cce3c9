// SPDX-License-Identifier: MIT
// Result and exemplar -> measures; density -> decibels.
#include "random_phase_judgement.h"

#include "random_phase_version.h"

#include <algorithm>
#include <cmath>

namespace lichen {

Result<void> judgeRandomPhase(const ComparedResult& result, bool hasGivenSpectrum,
                              const GaussianTargets& targets, NoiseComparison& comparison) {
  if (!hasGivenSpectrum) {
    const Result<LinearImage> version =
        randomPhaseVersion(result.exemplar, result.options.material.seed);
    if (!version)
      return version.error();
    comparison.gaussian = comparison.look.picture(version.value());
  }
  Result<std::vector<Measure>> measures =
      comparison.gaussian ? measureGaussianResult(comparison.exemplar, *comparison.gaussian,
                                                  comparison.result, targets)
                          : measureResult(comparison.exemplar, comparison.result);
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  if (hasGivenSpectrum)
    for (Measure& measure : comparison.measures)
      if (measure.name != kColorDistanceName && measure.target) {
        measure.target.reset();
        measure.remark = "no target: the noise has another spectrum on purpose";
      }
  return {};
}

LinearImage spectrumPicture(const std::vector<double>& density, int width, int height) {
  constexpr double kShownDecibels = 50.0;
  // 0 for a map that does not vary.
  const double largest = std::max(*std::max_element(density.begin(), density.end()), 1e-30);
  LinearImage image(width, height, 1);
  for (std::size_t i = 0; i < density.size(); ++i) {
    const double decibels = 10.0 * std::log10(std::max(density[i] / largest, 1e-30));
    image.values[i] = float(std::clamp(1.0 + decibels / kShownDecibels, 0.0, 1.0));
  }
  return image;
}

} // namespace lichen
