// SPDX-License-Identifier: MIT
// The page of a bake's report without its data, from analysis/report/page/.
#pragma once

#include <string_view>

namespace lichen {

extern const std::string_view kReportPage;

/// What the data, one JSON value, takes the place of.
inline constexpr std::string_view kReportDataMark = "@REPORT_DATA@";

} // namespace lichen
