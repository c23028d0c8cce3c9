// SPDX-License-Identifier: MIT
// The methods that bake, in the order of Method.
#include "method_analysis.h"

#include <array>

namespace lichen {

const MethodAnalysis& analysisOf(Method method) {
  static constexpr std::array<const MethodAnalysis*, 5> kAnalyses{
      &kTilingAnalysis, &kTextonAnalysis, &kLocalRandomPhaseAnalysis, &kMultipleKernelsAnalysis,
      &kQuiltingAnalysis};
  static_assert(kAnalyses.size() == std::variant_size_v<MethodMap>);
  return *kAnalyses[std::size_t(method)];
}

} // namespace lichen
