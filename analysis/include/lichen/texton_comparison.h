// SPDX-License-Identifier: MIT
// Compares a texton with other kernels of the same support and with the Gaussian texture of its
// exemplar.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/result.h>

#include <cstdint>

namespace lichen {

struct KernelJudgement {
  /// Relative model error [GLM14] eq. 5: the transport distance between the limit of the kernel's
  /// noise for many impacts and the exemplar's Gaussian texture; 0 for equal spectra.
  double modelError = 0.0;
  /// r^2 sum l^4 / (sum l^2)^2 over the texton's r^2 texels: 1 if all are equal in magnitude, 3 if
  /// they are normally distributed, r^2 if only one is not 0.
  double flatness = 0.0;

  /// The mean number of impacts of a Poisson process at which the noise has the excess kurtosis
  /// kNearlyNormal; 0 is normal. The excess kurtosis is flatness / impacts.
  [[nodiscard]] double impactsNeeded() const { return flatness / kNearlyNormal; }

  /// The excess kurtosis of 30 impacts, the papers' number, of a normally distributed kernel.
  static constexpr double kNearlyNormal = 0.1;
};

/// The kernels of [GLM14] figure 4, all with the same support.
struct KernelComparison {
  KernelJudgement texton;
  KernelJudgement luminance;   ///< the cropped luminance texton
  KernelJudgement randomPhase; ///< a crop of a random-phase texture
};

/// Judges the texton of the exemplar's map as noise `noise` of the bundle stores it; for a mix, the
/// texton of step `step`. The other kernels have its support and order. For the errors, all kernels
/// get the covariance of the exemplar's periodic component, which the spectrum comes from. The
/// exemplar is resampled to the size of the noise's exemplar.
/// Errors: usage for an index out of range, another method, or a map that the noise does not have;
/// badInput for an exemplar with other channels; resources if memory runs out. O(N log N) in the
/// exemplar's pixels; same bytes for any number of threads. Source: [GLM14] section 4.
[[nodiscard]] Result<KernelComparison> compareTexton(const Bundle& bundle, std::size_t noise,
                                                     const MapExemplar& exemplar,
                                                     std::size_t step = 0);

/// Returns the exemplar's Gaussian texture, the limit of a texton's noise, twice as wide and as
/// high: random phases with the mean and covariance of the noise's map. Opposite borders match.
/// Values are clamped to the range of the encoding. Errors: usage for a map with other channels,
/// resources if memory runs out. Sources: [GLM14] section 2.4, [GGM11].
[[nodiscard]] Result<MapExemplar> gaussianVersion(const NoiseMap& map, const MapExemplar& exemplar,
                                                  std::uint64_t seed);

} // namespace lichen
