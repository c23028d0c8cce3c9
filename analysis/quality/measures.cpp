// SPDX-License-Identifier: MIT
// Exemplar and result -> every measure with its target.
#include "boundary.h"

#include <lichen/measures.h>

#include <algorithm>

namespace lichen {
namespace {

/// Gradients across the grain have three times the energy of gradients along it.
constexpr double kStrongAnisotropy = 0.5;

/// Returns the measure with its value, or with a remark that says why these images have none.
Result<Measure> taken(Measure measure, const Result<double>& value) {
  if (value) {
    measure.value = value.value();
  } else if (value.error().kind == ErrorKind::badInput) {
    measure.remark = value.error().message;
  } else {
    return value.error();
  }
  return measure;
}

Measure spectrumMeasure(const SrgbImage& exemplar) {
  Measure measure{kSpectrumDistanceName,
                  "dB",
                  "difference of the radially averaged power spectra of the luminance",
                  {},
                  kSpectrumDistanceTargetDb,
                  {}};
  if (gradientAnisotropy(exemplar) >= kStrongAnisotropy) {
    measure.target = kAnisotropicSpectrumDistanceTargetDb;
    measure.remark = "the exemplar is strongly anisotropic, which doubles the target";
  }
  return measure;
}

/// Uses the largest support, up to the default, that fits both images.
Result<double> autocovarianceErrorOf(const SrgbImage& exemplar, const SrgbImage& result) {
  constexpr int kSupport = 32, kSmallestSupport = 2, kSupportsPerSide = 16;
  const int room = std::min(shorterSide(exemplar), shorterSide(result)) / kSupportsPerSide;
  return autocovarianceError(exemplar, result, std::clamp(room, kSmallestSupport, kSupport));
}

} // namespace

Result<std::vector<Measure>> measureResult(const SrgbImage& exemplar, const SrgbImage& result) {
  return withinMemory(exhausted, [&]() -> Result<std::vector<Measure>> {
    if (auto error = refusal(exemplar, result, 1))
      return *error;
    const Result<Measure> measures[] = {
        taken({kColorDistanceName,
               "",
               "distance between the sets of colours, in code values",
               {},
               kColorDistanceTarget,
               {}},
              colorDistance(exemplar, result)),
        taken(spectrumMeasure(exemplar), spectrumDistanceDb(exemplar, result)),
        taken({kAutocovarianceErrorName,
               "",
               "difference of the autocovariances, as a share of the exemplar's",
               {},
               kAutocovarianceErrorTarget,
               {}},
              autocovarianceErrorOf(exemplar, result)),
        taken({kSeamVisibilityName,
               "",
               "straight edges of the result over the exemplar's",
               {},
               kSeamVisibilityTarget,
               {}},
              seamVisibility(exemplar, result))};
    std::vector<Measure> all;
    for (const Result<Measure>& measure : measures) {
      if (!measure)
        return measure.error();
      all.push_back(measure.value());
    }
    return all;
  });
}

Result<std::vector<Measure>> measureGaussianResult(const SrgbImage& exemplar,
                                                   const SrgbImage& gaussian,
                                                   const SrgbImage& result,
                                                   const GaussianTargets& targets) {
  return withinMemory(exhausted, [&]() -> Result<std::vector<Measure>> {
    Result<std::vector<Measure>> measures = measureResult(exemplar, result);
    if (!measures)
      return measures.error();
    std::vector<Measure> all;
    for (Measure& measure : measures.value()) {
      const bool isSpectrum = measure.name == kSpectrumDistanceName;
      if (isSpectrum || (measure.name == kColorDistanceName && !targets.hasColors)) {
        measure.target.reset();
        if (measure.value)
          measure.remark = "no target: the noise has random phases";
      }
      if (measure.name == kAutocovarianceErrorName) // its spectrum has a target instead
        measure.target.reset();
      all.push_back(std::move(measure));
      if (!isSpectrum)
        continue;
      Result<Measure> distance =
          taken({kGaussianSpectrumDistanceName,
                 "dB",
                 "the same difference to the exemplar's Gaussian version, of random phases",
                 {},
                 gradientAnisotropy(exemplar) >= kStrongAnisotropy ? targets.anisotropicSpectrumDb
                                                                   : targets.spectrumDb,
                 {}},
                spectrumDistanceDb(gaussian, result));
      if (!distance)
        return distance.error();
      all.push_back(std::move(distance).value());
    }
    return all;
  });
}

Result<Measure> measureLattice(const SrgbImage& result, const LatticeView& view) {
  return withinMemory(exhausted, [&] {
    return taken({kLatticeVisibilityName,
                  "",
                  "how much the contrast follows the lattice",
                  {},
                  kLatticeVisibilityTarget,
                  {}},
                 latticeVisibility(result, view));
  });
}

} // namespace lichen
