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

} // namespace lichen
