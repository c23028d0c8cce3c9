// SPDX-License-Identifier: MIT
// The share of a texton's variance that remains at a level of detail: the CPU twin of
// lichenTextonLevelRetained.
#pragma once

#include <array>
#include <lichen_interface.h>

namespace lichen::texton {

/// Returns the share for each channel at `level` >= 0, as interpolated between the texels of a mip.
[[nodiscard]] std::array<float, 3> levelRetained(const shader::LichenMap& map, float level);

} // namespace lichen::texton
