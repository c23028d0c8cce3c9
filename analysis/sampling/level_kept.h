// SPDX-License-Identifier: MIT
// The share of a map's variance that the mips of its image keep: the CPU twin of
// shaders_glsl/noise/mip_variance.glsl.
#pragma once

#include <lichen_interface.h>

namespace lichen {

/// The amplitude that the texels of a mip keep, of that of the Gaussian value; `bytes` are those of
/// a channel, LichenMap::mipKept0 and so on.
[[nodiscard]] float mipKept(const shader::uvec4& bytes, int mip);

/// The share of the variance that a level >= 0 of a Gaussian image keeps: a trilinear blend of a
/// mip and its own average.
[[nodiscard]] float levelKept(const shader::LichenMap& map, float level);

} // namespace lichen
