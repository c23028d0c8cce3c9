// SPDX-License-Identifier: MIT
// What a noise and its exemplar are judged by, as the command line and the report write it.
#pragma once

#include <lichen/json_tree.h>
#include <lichen/measures.h>
#include <lichen/suitability.h>
#include <lichen/texton_comparison.h>

namespace lichen {

/// `name`, `meaning`, `unit`, `value`, `target`, `met` and `remark`; null where there is no value
/// or no target, and `met` where there is not both.
[[nodiscard]] JsonTree jsonOf(const Measure& measure);

/// A list of the texton, the luminance texton and the random-phase kernel: `name`, `modelError`,
/// `flatness` and `impactsNeeded`.
[[nodiscard]] JsonTree jsonOf(const KernelComparison& kernels);

/// `name`, `score`, `level`, `sentence` and `remedy`.
[[nodiscard]] JsonTree jsonOf(const Risk& risk);

} // namespace lichen
