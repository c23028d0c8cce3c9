// SPDX-License-Identifier: MIT
// Bakes exemplars for tiling and blending on a simplex grid [HN18].
#pragma once

#include <lichen/baked_noise.h>
#include <lichen/exemplar.h>
#include <lichen/gaussianization.h>
#include <lichen/result.h>

#include <span>
#include <string>

namespace lichen {

/// Tiling has no options beyond the Gaussianization's.
using TilingOptions = GaussianizationOptions;

/// Gaussianizes each map by optimal transport, makes it periodic, and fits its inverse table with
/// prefiltered mip levels. Needs at least one map, each within the ranges of MapExemplar; maps may
/// differ in size. `name` names the noise and, with the target, its tables.
/// Errors: usage for options or maps outside their ranges, or for a map that needs an inverse table
/// when none is allowed; resources if memory runs out; environment if `options.progress` stops it.
/// Thread-safe; runs on all cores; same bytes for any number of threads. O(N log N) in the number
/// of pixels. Source: [HN18] section 4.
[[nodiscard]] Result<MethodBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                                            const TilingOptions& options);

} // namespace lichen
