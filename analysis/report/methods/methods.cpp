// SPDX-License-Identifier: MIT
// The methods that comparison and report support, in the order of Method.
#include "../method_report.h"

#include <array>

namespace lichen {

extern const MethodReport kTilingReport, kTextonReport, kLocalRandomPhaseReport,
    kMultipleKernelsReport, kQuiltingReport;

const MethodReport& reportOf(Method method) {
  static constexpr std::array<const MethodReport*, 5> kReports{
      &kTilingReport, &kTextonReport, &kLocalRandomPhaseReport, &kMultipleKernelsReport,
      &kQuiltingReport};
  static_assert(kReports.size() == std::variant_size_v<MethodMap>);
  return *kReports[std::size_t(method)];
}

} // namespace lichen
