// SPDX-License-Identifier: MIT
// The risk of a noise of random phases: outlines are lost.
#pragma once

#include "method_report.h"

namespace lichen {

/// The risk "outlines"; where it is not none, `more` are settings that help before its own. Slow
/// variation is no risk: such a noise has it.
[[nodiscard]] Result<std::vector<Risk>> outlineRisks(const MapExemplar& map,
                                                     const std::vector<BakeSetting>& more,
                                                     const Progress& progress);

} // namespace lichen
