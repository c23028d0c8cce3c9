// SPDX-License-Identifier: MIT
// Bakes exemplars for texton noise: a Gaussian texture synthesized by sparse convolution [GLM17].
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// The covariance of the noise.
enum class TextonVariance {
  exemplar, ///< the photograph's: the noise has its contrast
  periodic, ///< its periodic component's, which the spectrum comes from
};

struct TextonOptions {
  int support = 64; ///< side of the area that an impact reaches, texels, [4, kMaxTextonSide]
  int order = 1;    ///< order of the B-spline between coefficients: 0, 1 or 3
  int bits = 8;     ///< precision as for tiling's tables: 8 gives 16-bit floats, 16 gives 32-bit
  TextonVariance variance = TextonVariance::exemplar;
  std::uint32_t fitSeed = 1; ///< seed of the initial phases of the fit
  Progress progress;         ///< empty: no reports
};
inline constexpr NumberRange kTextonSupportRange{4.0, double(kMaxTextonSide)};

/// How close a texton is to the Gaussian texture that it approximates.
struct TextonQuality {
  /// Relative model error [GLM14] eq. 5 over all channels, where each quantity (colours, slopes,
  /// every other channel) is measured in its own standard deviation: 0 for equal spectra.
  double modelError = 0.0;
  std::vector<double> channelErrors; ///< of each channel alone, in the order of the maps
  /// The error on one half of the exemplar of a texton fitted to the other half. It describes the
  /// material, not just this photograph. Absent if a half is smaller than the support.
  std::optional<double> heldOutError;
  /// r^2 sum l^4 / (sum l^2)^2 of the first map's texton, for colours of its luminance: 1 if all
  /// texels are equal in magnitude, 3 if they are Gaussian, more if few dominate, which takes more
  /// impacts.
  double flatness = 0.0;
  /// The largest error of a covariance between two channels, relative to the product of their
  /// standard deviations, computed from the texels as stored (half floats or floats).
  double covarianceError = 0.0;
};

/// The result of a bake. The maps of `noise` number its tables from 0.
struct TextonBake {
  Noise noise; ///< maps in the order given
  std::vector<Table> tables;
  TextonQuality quality;
};

/// Fits one texton to all maps together, which preserves their correlations. Smaller maps are
/// resampled to the size of the largest. Needs at least one map, each within the ranges of
/// MapExemplar and with a different target. The support is no larger than the exemplar. `name`
/// names the noise and, with the target, its tables.
/// Errors: usage for options or maps outside their ranges; badInput if the photograph varies but
/// its periodic component or the few coefficients do not, so that no texton has its covariance;
/// resources if memory runs out; environment if `options.progress` stops it.
/// Thread-safe; runs on all cores; same bytes for any number of threads. O(N log N) in the number
/// of pixels. Sources: [GLM17] section 4, [GLM14], [M11].
[[nodiscard]] Result<TextonBake> bakeTexton(std::string name, std::span<const MapExemplar> maps,
                                            const TextonOptions& options);

} // namespace lichen
