// SPDX-License-Identifier: MIT
// Exemplar and result -> every measure with its target.
#include "boundary.h"

#include <lichen/measures.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>

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

// Plane -> the direction that its gradients prefer, and how much, from their structure tensor.
// Source: [BG87] Bigun and Granlund, Optimal Orientation Detection of Linear Symmetry, 1987.

GradientDirection gradientDirection(std::span<const float> plane, int width, int height) {
  // [S00] 3 x 3 operator, whose direction is right to a fraction of a degree. Differences of
  // neighbours favour the axes, by up to 5 degrees.
  constexpr double kSide = 3.0 / 32.0, kMiddle = 10.0 / 32.0;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (int y = 1; y + 1 < height; ++y)
    for (int x = 1; x + 1 < width; ++x) {
      const auto at = [&](int dx, int dy) {
        return double(plane[std::size_t(y + dy) * std::size_t(width) + std::size_t(x + dx)]);
      };
      const double right = kSide * (at(1, -1) - at(-1, -1) + at(1, 1) - at(-1, 1)) +
                           kMiddle * (at(1, 0) - at(-1, 0));
      const double down = kSide * (at(-1, 1) - at(-1, -1) + at(1, 1) - at(1, -1)) +
                          kMiddle * (at(0, 1) - at(0, -1));
      xx += right * right;
      xy += right * down;
      yy += down * down;
    }
  const double energy = xx + yy;
  if (energy <= 0.0)
    return {};
  return {std::hypot(xx - yy, 2.0 * xy) / energy, 0.5 * std::atan2(2.0 * xy, xx - yy)};
}

double gradientAnisotropy(const SrgbImage& image) {
  return gradientDirection(luminancePlane(image), image.width, image.height).anisotropy;
}

} // namespace lichen
