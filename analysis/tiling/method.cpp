// SPDX-License-Identifier: MIT
// Tiling as one of the methods of a bake.
#include "method_analysis.h"

#include <fmt/format.h>

namespace lichen {
namespace {

/// Measured: 139 to 148 bytes per pixel for one map of 512 to 2048 pixels a side, 161 for one of
/// 8192 (docs/benchmarks.md), 238 for four maps of 1024.
BakeMemory memory(const MethodOptions&) { return {32.0, 128.0}; }

Result<MethodBake> bake(const MethodOptions& options, const MethodInput& input) {
  Result<MethodBake> baked =
      bakeTiling(input.name, input.maps, optionsFor<TilingOptions>(options, input));
  if (!baked)
    return baked;
  MethodBake& result = baked.value();
  if (const Grain grain = result.noise.as<TilingNoise>().grain; grain != Grain::none)
    result.notes.push_back(fmt::format("long streaks along {}: cells are twice as long along them; "
                                       "a streak ends after about the length of the picture",
                                       nameOf(grain)));
  return baked;
}

} // namespace

const MethodAnalysis kTilingAnalysis{memory, bake};

} // namespace lichen
