// SPDX-License-Identifier: MIT
// Local random phase as one of the methods of a bake.
#include "method_analysis.h"

#include <fmt/format.h>

namespace lichen {
namespace {

/// As tiling needs, and the spectra of all channels. A structure is at most four times as large
/// as its exemplar, with levels in floats and in texels, twice if there is a list.
BakeMemory memory(const MethodOptions& options) {
  const bool mayHaveStructure = std::get<LocalRandomPhaseOptions>(options).structure != 0.0;
  return {64.0, mayHaveStructure ? 460.0 : 160.0};
}

Result<MethodBake> bake(const MethodOptions& options, const MethodInput& input) {
  const auto own = optionsFor<LocalRandomPhaseOptions>(options, input);
  Result<MethodBake> baked = bakeLocalRandomPhase(input.name, input.maps, own);
  if (!baked)
    return baked;
  MethodBake& result = baked.value();
  const double structure = result.figures.structure;
  if (structure > 0.0 && !own.structure)
    result.notes.push_back(
        fmt::format("the exemplar repeats, so {:.0f} % of its variation keeps its structure; for "
                    "none, as solids need: {}",
                    100.0 * structure, input.words({"structure", "0"})));
  if (structure == 0.0 && (own.guide || own.turbulence > 0.0))
    result.notes.push_back(fmt::format("{} has no effect, since the noise has no structure",
                                       input.words({own.guide ? "guide" : "turbulence", ""})));
  return baked;
}

} // namespace

const MethodAnalysis kLocalRandomPhaseAnalysis{memory, bake};

} // namespace lichen
