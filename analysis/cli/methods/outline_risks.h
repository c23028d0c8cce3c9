// SPDX-License-Identifier: MIT
// The risk of a noise of random phases: outlines are lost.
#pragma once

#include "method_command.h"

namespace lichen::cli {

/// The risk "outlines" of each map; where it is not none, `more` are settings that help beside its
/// own. Slow variation is no risk: such a noise has it.
[[nodiscard]] Result<std::vector<std::vector<Risk>>>
outlineRisks(std::span<const MapExemplar> maps, const SharedOptions& shared,
             const std::vector<BakeSetting>& more);

} // namespace lichen::cli
