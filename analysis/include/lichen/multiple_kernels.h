// SPDX-License-Identifier: MIT
// Bakes exemplars for multiple-kernels noise [MKN12].
#pragma once

#include <lichen/bundle.h>
#include <lichen/gaussianization.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen {

struct MultipleKernelsOptions : GaussianizationOptions {
  KernelWindow window = KernelWindow::gabor;
  int kernels = 8; ///< at most; fewer where fewer do
  /// The mean number of impacts that reach a point, over all kernels; kImpactsRange.
  double impacts = 30.0;
  /// In place of the exemplar's, which then gives colours only: the channels of the noise hardly
  /// correlate in space.
  std::optional<SpectrumPicture> spectrum;
};
inline constexpr NumberRange kKernelsRange{1.0, double(kMostKernels)};

/// The result of a bake. The maps of `noise` number its tables from 0.
struct MultipleKernelsBake {
  Noise noise; ///< maps in the order given
  std::vector<Table> tables;
  bool exemplarWasPeriodic = true;
  /// The root mean square of the difference between the spectra of the exemplar and the noise, over
  /// all directions.
  double spectrumErrorDb = 0.0;
};

/// Gaussianizes the maps as bakeTiling() does, and fits kernels to the sum of their power spectra;
/// all maps take the same impacts. The noise has the histogram of the exemplar, the covariance of
/// its Gaussian values and nearly their spectrum; what the phases of the exemplar hold is lost,
/// also those between channels. Maps may differ in size. Needs at least one map, each within the
/// ranges of MapExemplar and with a different target. `name` names the noise and, with the target,
/// its tables. Errors: usage for options or maps outside their ranges; badInput for a spectrum
/// without power; resources if memory runs out; environment if `options.progress` stops it.
/// Thread-safe; runs on all cores; same bytes for any number of threads. O(N (log N + kernels)) in
/// the number of pixels.
[[nodiscard]] Result<MultipleKernelsBake>
bakeMultipleKernels(std::string name, std::span<const MapExemplar> maps,
                    const MultipleKernelsOptions& options);

} // namespace lichen
