// SPDX-License-Identifier: MIT
// Quilting as one of the methods of a bake.
#include "method_analysis.h"

namespace lichen {
namespace {

BakeMemory memory(const MethodOptions&) { return {32.0, 128.0}; }

Result<MethodBake> bake(const MethodOptions& options, const MethodInput& input) {
  return bakeQuilting(input.name, input.maps, optionsFor<QuiltingOptions>(options, input));
}

} // namespace

const MethodAnalysis kQuiltingAnalysis{memory, bake};

} // namespace lichen
