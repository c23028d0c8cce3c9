// SPDX-License-Identifier: MIT
// The methods of the analysis, in the order of Method.
#include "method_analysis.h"
#include "texton/texton_analysis.h"
#include "tiling/tiling_analysis.h"

namespace lichen {

const MethodAnalysis& analysisOf(Method method) {
  static const TilingAnalysis kTiling;
  static const TextonAnalysis kTexton;
  static const std::array<const MethodAnalysis*, 2> kAnalyses{&kTiling, &kTexton};
  static_assert(kAnalyses.size() == std::variant_size_v<MethodMap>);
  return *kAnalyses[std::size_t(method)];
}

} // namespace lichen
