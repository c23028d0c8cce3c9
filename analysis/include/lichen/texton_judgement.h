// SPDX-License-Identifier: MIT
// Compares a texton with the Gaussian texture of its exemplar.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/result.h>

#include <cstdint>

namespace lichen {

struct TextonJudgement {
  /// Relative model error [GLM14] eq. 5: the transport distance between the limit of the texton's
  /// noise for many impacts and the exemplar's Gaussian texture; 0 for equal spectra.
  double modelError = 0.0;
  /// r^2 sum l^4 / (sum l^2)^2 over the texton's r^2 texels: 1 if all are equal in magnitude, 3 if
  /// they are normally distributed, r^2 if only one is not 0.
  double flatness = 0.0;
};

/// Judges the texton of the exemplar's map as noise `noise` of the bundle stores it; for a mix, the
/// texton of step `step`. For the error it gets the covariance of the exemplar's periodic
/// component, which the spectrum comes from. The exemplar is resampled to the size of the noise's
/// exemplar.
/// Errors: usage for an index out of range, another method, or a map that the noise does not have;
/// badInput for an exemplar with other channels; resources if memory runs out. O(N log N) in the
/// exemplar's pixels; same bytes for any number of threads.
[[nodiscard]] Result<TextonJudgement> judgeTexton(const Bundle& bundle, std::size_t noise,
                                                  const MapExemplar& exemplar,
                                                  std::size_t step = 0);

/// Returns the exemplar's Gaussian texture, the limit of a texton's noise, twice as wide and as
/// high: random phases with the mean and covariance of the noise's map. Opposite borders match.
/// Values are clamped to the range of the encoding. Errors: usage for a map with other channels,
/// resources if memory runs out. Sources: [GLM14] section 2.4, [GGM11].
[[nodiscard]] Result<MapExemplar> gaussianVersion(const NoiseMap& map, const MapExemplar& exemplar,
                                                  std::uint64_t seed);

} // namespace lichen
