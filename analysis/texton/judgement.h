// SPDX-License-Identifier: MIT
// The judgement of a stored texton, and the Gaussian texture that it is compared with.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>

#include <cstddef>
#include <cstdint>

namespace lichen::texton {

struct TextonJudgement {
  /// Relative model error [GLM14] eq. 5: the transport distance between the limit of the texton's
  /// noise for many impacts and the exemplar's Gaussian texture; 0 for equal spectra.
  double modelError = 0.0;
  /// r^2 sum l^4 / (sum l^2)^2 over the texton's r^2 texels: 1 if all are equal in magnitude, 3 if
  /// they are normally distributed, r^2 if only one is not 0.
  double flatness = 0.0;
};

/// Judges the texton of a map of `noise`, as the bundle stores it; for a mix, the texton of step
/// `step`. `exemplar` is the map's, of any size. For the error the texton gets the covariance of
/// the exemplar's periodic component, which the spectrum comes from. O(N log N) in the exemplar's
/// pixels; same bytes for any number of threads. Throws std::bad_alloc.
[[nodiscard]] TextonJudgement judgeTexton(const Bundle& bundle, const Noise& noise,
                                          const NoiseMap& map, const MapExemplar& exemplar,
                                          std::size_t step = 0);

/// Returns the exemplar's Gaussian texture, the limit of a texton's noise: random phases with the
/// mean and covariance of the noise's map. Opposite borders match. Values are clamped to the range
/// of the encoding. Throws std::bad_alloc. Source: [GGM11].
[[nodiscard]] MapExemplar gaussianVersion(const NoiseMap& map, const MapExemplar& exemplar,
                                          std::uint32_t seed);

} // namespace lichen::texton
