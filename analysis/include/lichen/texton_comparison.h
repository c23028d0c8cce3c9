// SPDX-License-Identifier: MIT
// What a texton is worth: beside other spots of its support, and beside the Gaussian texture of its
// exemplar.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/result.h>

#include <cstdint>

namespace lichen {

struct KernelJudgement {
  /// Relative model error [GLM17 section 4.4]: the transport distance of its noise's limit for many
  /// impacts to the exemplar's Gaussian texture; 0 for equal spectra.
  double modelError = 0.0;
  /// r^2 sum l^4 / (sum l^2)^2 over the texton's r^2 texels: 1 where all count alike, 3 where they
  /// are normally distributed, r^2 where one does.
  double flatness = 0.0;

  /// Mean number of impacts of a Poisson process at which the noise has the excess kurtosis
  /// kNearlyNormal; 0 is normal. The excess is flatness / impacts.
  [[nodiscard]] double impactsNeeded() const { return flatness / kNearlyNormal; }

  /// That of 30 impacts, the papers' number, of a spot whose values are normally distributed.
  static constexpr double kNearlyNormal = 0.1;
};

/// The kernels of [GLM14] figure 4, of one support.
struct KernelComparison {
  KernelJudgement texton;
  KernelJudgement luminance;   ///< the luminance texton, cropped
  KernelJudgement randomPhase; ///< a part of a random-phase texture
};

/// The texton of the exemplar's map as noise `noise` of the bundle stores it, of a mix the first;
/// the other spots have its support and order. For their errors all get the covariance of the
/// exemplar's periodic component, of which the spectrum is. The exemplar is resampled to the size
/// that the noise's was; `step` is of a mix. Errors: usage for an index out of range, another
/// method, or a map that the noise has not; badInput for an exemplar of other channels; resources
/// for memory. O(N log N) in the exemplar's pixels; same bytes for any number of threads. Source:
/// [GLM14] section 4.
[[nodiscard]] Result<KernelComparison> compareTexton(const Bundle& bundle, std::size_t noise,
                                                     const MapExemplar& exemplar,
                                                     std::size_t step = 0);

/// The exemplar's Gaussian texture, which a texton's noise tends to, twice as wide and as high:
/// random phases, with the mean and covariance of the noise's map. Borders fit together. Values are
/// clamped to what the encoding can show. Errors: usage for a map of other channels, resources for
/// memory. Sources: [GLM14] section 2.4, [GGM11].
[[nodiscard]] Result<MapExemplar> gaussianVersion(const NoiseMap& map, const MapExemplar& exemplar,
                                                  std::uint64_t seed);

} // namespace lichen
