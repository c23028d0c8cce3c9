// SPDX-License-Identifier: MIT
// Bakes exemplars for texton noise: a Gaussian texture by sparse convolution [GLM17].
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

/// Which covariance the noise has.
enum class TextonVariance {
  exemplar, ///< the photograph's: the noise has its contrast
  periodic, ///< that of its periodic component, which is what the spectrum is of
};

/// How a texton's coefficients are found.
enum class TextonFit {
  transport,   ///< least transport distance to the exemplar's Gaussian texture
  projections, ///< [GLM17] algorithm 1 as printed, for comparison
};

struct TextonOptions {
  int support = 64; ///< texels a side that an impact reaches, [4, kMaxTextonSide]
  int order = 1;    ///< of the B-spline between coefficients: 0, 1 or 3
  int bits = 8;     ///< as of tiling's tables: 8 gives 16-bit floats, 16 gives 32-bit ones
  TextonVariance variance = TextonVariance::exemplar;
  TextonFit fit = TextonFit::transport;
  std::uint32_t fitSeed = 1; ///< of the phases that the fit starts from
  Progress progress;         ///< empty: nobody watches
};
inline constexpr NumberRange kTextonSupportRange{4.0, double(kMaxTextonSide)};

/// How near a texton is to the Gaussian texture that it stands for.
struct TextonQuality {
  /// Relative model error [GLM17 section 4.4] over all channels, each quantity (colours, slopes,
  /// every other channel) in its own deviation: 0 for equal spectra.
  double modelError = 0.0;
  std::vector<double> channelErrors; ///< of each channel alone, in the order of the maps
  /// Of one half of the exemplar, the texton fitted to the other: what holds for the material and
  /// not for the one picture. None where a half is smaller than the support.
  std::optional<double> heldOutError;
  /// r^2 sum l^4 / (sum l^2)^2 of the first map's texton, of colours their luminance: 1 where
  /// all count alike, 3 where they are Gaussian, more where few count and more impacts are needed.
  double flatness = 0.0;
  /// The largest error of a covariance between two channels over their two deviations, of the
  /// texels as they are stored, half floats or floats.
  double covarianceError = 0.0;
};

/// What a bake made: tables numbered from 0 in the maps of `noise`.
struct TextonBake {
  Noise noise; ///< its maps in the order given
  std::vector<Table> tables;
  TextonQuality quality;
};

/// Fits one texton to all maps together, so that their correlations are kept: maps of other sizes
/// are resampled to the largest. At least one map, each within the ranges of MapExemplar, of other
/// targets. The support is no larger than the exemplar. `name` names the noise and, with the
/// target, its tables.
/// Errors: usage for options or maps outside their ranges; badInput where the photograph varies and
/// its periodic component does not, or where so few coefficients do not, so that no texton has its
/// covariance; resources when memory
/// does not suffice, environment when `options.progress` stops it.
/// Thread-safe; runs on all cores, and the same bytes for any number of threads. O(N log N) in the
/// number of pixels. Sources: [GLM17] section 4, [GLM14], [M11].
[[nodiscard]] Result<TextonBake> bakeTexton(std::string name, std::span<const MapExemplar> maps,
                                            const TextonOptions& options);

} // namespace lichen
