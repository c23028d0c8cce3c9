// SPDX-License-Identifier: MIT
// The report page of a bake without its data, from analysis/report/page/.
#pragma once

#include <string_view>

namespace lichen {

extern const std::string_view kReportPage;

/// The text in the page that the data, one JSON value, replaces.
inline constexpr std::string_view kReportDataMark = "@REPORT_DATA@";

} // namespace lichen
