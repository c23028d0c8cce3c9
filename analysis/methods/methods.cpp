// SPDX-License-Identifier: MIT
// The methods of the analysis, in the order of Method.
#include "local_random_phase/local_random_phase_analysis.h"
#include "method_analysis.h"
#include "multiple_kernels/multiple_kernels_analysis.h"
#include "quilting/quilting_analysis.h"
#include "texton/texton_analysis.h"
#include "tiling/tiling_analysis.h"

namespace lichen {

const MethodAnalysis& analysisOf(Method method) {
  static const TilingAnalysis kTiling;
  static const TextonAnalysis kTexton;
  static const LocalRandomPhaseAnalysis kLocalRandomPhase;
  static const MultipleKernelsAnalysis kMultipleKernels;
  static const QuiltingAnalysis kQuilting;
  static const std::array<const MethodAnalysis*, 5> kAnalyses{
      &kTiling, &kTexton, &kLocalRandomPhase, &kMultipleKernels, &kQuilting};
  static_assert(kAnalyses.size() == std::variant_size_v<MethodMap>);
  return *kAnalyses[std::size_t(method)];
}

} // namespace lichen
