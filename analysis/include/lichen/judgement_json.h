// SPDX-License-Identifier: MIT
// The quality of a noise and its exemplar as JSON, for the command line and the report.
#pragma once

#include <lichen/measures.h>
#include <lichen/suitability.h>

#include <nlohmann/json_fwd.hpp>

namespace lichen {

/// `name`, `meaning`, `unit`, `value`, `target`, `met` and `remark`. A missing value or target is
/// null; `met` is null if either is missing.
[[nodiscard]] nlohmann::ordered_json jsonOf(const Measure& measure);

/// `name`, `score`, `level`, `sentence` and `remedy`, whose settings are in these words.
[[nodiscard]] nlohmann::ordered_json jsonOf(const Risk& risk, SettingWords words);

} // namespace lichen
