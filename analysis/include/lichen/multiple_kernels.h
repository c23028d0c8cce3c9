// SPDX-License-Identifier: MIT
// Bakes exemplars for multiple-kernels noise [MKN12].
#pragma once

#include <lichen/baked_noise.h>
#include <lichen/gaussianization.h>
#include <lichen/pattern.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// A regular pattern that noise perturbs. Both together have the covariance of the exemplar's
/// Gaussian values, whatever the amount; few waves have few tones, so that histograms are the
/// exemplar's only where the noise is strong. [MKN12] section 5.
struct Perturbation {
  double amount = 1.0; ///< of the noise, for one of the pattern; kPerturbationRange
  /// The waves of the pattern; their relative amplitudes count. They take 1 / (1 + amount^2) of the
  /// luminance's variance, and change other maps as far as these correlate with luminance. If it is
  /// empty, the pattern is the strongest waves of the exemplar, and the noise has the rest of its
  /// spectrum.
  std::vector<PatternWave> pattern;
  int cosines = 40; ///< at most, [1, kMostPatternCosines]; the strongest
};
inline constexpr NumberRange kPerturbationRange{0.0, 16.0};

struct MultipleKernelsOptions : GaussianizationOptions {
  KernelWindow window = KernelWindow::gabor;
  int kernels = 8; ///< at most; fewer where fewer do
  /// The mean number of impacts that reach a point, over all kernels; rings take
  /// twice as many. kImpactsRange.
  double impacts = 30.0;
  /// In place of the exemplar's, which then gives colours only: the channels of the noise hardly
  /// correlate in space.
  std::optional<SpectrumPicture> spectrum;
  std::optional<Perturbation> perturbation;
};
inline constexpr NumberRange kKernelsRange{1.0, double(kMostKernels)};

/// Gaussianizes the maps as bakeTiling() does, and fits kernels to the sum of their power spectra;
/// all maps take the same impacts. The noise has the histogram of the exemplar, the covariance of
/// its Gaussian values and nearly their spectrum; what the phases of the exemplar hold is lost,
/// also those between channels. Maps may differ in size. Needs at least one map, each within the
/// ranges of MapExemplar and with a different target. `name` names the noise and, with the target,
/// its tables. Errors: usage for options or maps outside their ranges; badInput for a spectrum
/// without power or a pattern that does not vary or has a frequency beyond kMostKernelFrequency;
/// resources if memory runs out; environment if `options.progress` stops it. Thread-safe; runs on
/// all cores; same bytes for any number of threads. O(N (log N + kernels)) in the number of pixels.
[[nodiscard]] Result<MethodBake> bakeMultipleKernels(std::string name,
                                                     std::span<const MapExemplar> maps,
                                                     const MultipleKernelsOptions& options);

/// "7 kernels with the window gabor, 2 of them rings, and a pattern of 3 cosines".
[[nodiscard]] std::string kernelWords(const MultipleKernelsNoise& noise);

} // namespace lichen
