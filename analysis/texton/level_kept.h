// SPDX-License-Identifier: MIT
// The share of a texton's variance that a level of its mips keeps: the CPU twin of
// lichenTextonLevelKept.
#pragma once

#include <array>
#include <lichen_interface.h>

namespace lichen::texton {

/// For each channel, at a level >= 0, interpolated between the texels of a mip.
[[nodiscard]] std::array<float, 3> levelKept(const shader::LichenMap& map, float level);

} // namespace lichen::texton
