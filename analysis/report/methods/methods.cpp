// SPDX-License-Identifier: MIT
// The methods that comparison and report support, in the order of Method.
#include "local_random_phase_report.h"
#include "multiple_kernels_report.h"
#include "quilting_report.h"
#include "texton_report.h"
#include "tiling_report.h"

#include <array>

namespace lichen {

const MethodReport& reportOf(Method method) {
  static const TilingReport kTiling;
  static const TextonReport kTexton;
  static const LocalRandomPhaseReport kLocalRandomPhase;
  static const MultipleKernelsReport kMultipleKernels;
  static const QuiltingReport kQuilting;
  static const std::array<const MethodReport*, 5> kReports{&kTiling, &kTexton, &kLocalRandomPhase,
                                                           &kMultipleKernels, &kQuilting};
  static_assert(kReports.size() == std::variant_size_v<MethodMap>);
  return *kReports[std::size_t(method)];
}

} // namespace lichen
