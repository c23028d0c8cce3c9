// SPDX-License-Identifier: MIT
// Bakes exemplars for texton noise: a Gaussian texture synthesized by sparse convolution [GLM17].
#pragma once

#include <lichen/baked_noise.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace lichen {

struct TextonOptions {
  int support = 64;  ///< side of the area that an impact reaches, texels, [4, kMaxTextonSide]
  int order = 1;     ///< order of the B-spline between coefficients: 0, 1 or 3
  int bits = 8;      ///< precision as for tiling's tables: 8 gives 16-bit floats, 16 gives 32-bit
  Progress progress; ///< empty: no reports
};
inline constexpr NumberRange kTextonSupportRange{4.0, double(kMaxTextonSide)};

/// Fits one texton to all maps together, which preserves their correlations. Smaller maps are
/// resampled to the size of the largest. Needs at least one map, each within the ranges of
/// MapExemplar and with a different target. The support is no larger than the exemplar. `name`
/// names the noise and, with the target, its tables.
/// Errors: usage for options or maps outside their ranges; badInput if the photograph varies but
/// its periodic component or the few coefficients do not, so that no texton has its covariance;
/// resources if memory runs out; environment if `options.progress` stops it.
/// Thread-safe; runs on all cores; same bytes for any number of threads. O(N log N) in the number
/// of pixels. Sources: [GLM17] section 4, [GLM14], [M11].
[[nodiscard]] Result<MethodBake> bakeTexton(std::string name, std::span<const MapExemplar> maps,
                                            const TextonOptions& options);

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

/// Returns the exemplar's Gaussian texture, the limit of a texton's noise: random phases with the
/// mean and covariance of the noise's map. Opposite borders match. Values are clamped to the range
/// of the encoding. Errors: usage for a map with other channels, resources if memory runs out.
/// Source: [GGM11].
[[nodiscard]] Result<MapExemplar> gaussianVersion(const NoiseMap& map, const MapExemplar& exemplar,
                                                  std::uint64_t seed);

} // namespace lichen
