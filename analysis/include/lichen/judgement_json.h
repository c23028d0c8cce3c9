// SPDX-License-Identifier: MIT
// The quality of a noise and its exemplar as JSON, for the command line and the report.
#pragma once

#include <lichen/measures.h>
#include <lichen/suitability.h>
#include <lichen/texton_comparison.h>

#include <nlohmann/json_fwd.hpp>

namespace lichen {

/// `name`, `meaning`, `unit`, `value`, `target`, `met` and `remark`. A missing value or target is
/// null; `met` is null if either is missing.
[[nodiscard]] nlohmann::ordered_json jsonOf(const Measure& measure);

/// A list with the texton, the luminance texton and the random-phase kernel. Each has `name`,
/// `modelError`, `flatness` and `impactsNeeded`.
[[nodiscard]] nlohmann::ordered_json jsonOf(const KernelComparison& kernels);

/// `name`, `score`, `level`, `sentence` and `remedy`, whose settings are in these words.
[[nodiscard]] nlohmann::ordered_json jsonOf(const Risk& risk, SettingWords words);

} // namespace lichen
