// SPDX-License-Identifier: MIT
// What of a map's variance the mips of its image keep: the CPU twin of
// shaders_glsl/noise/mip_variance.glsl, and of lichenTextonKept.
#pragma once

#include <lichen_interface.h>

namespace lichen {

/// The amplitude that the texels of a mip keep, of that of the Gaussian value.
[[nodiscard]] float mipKept(const shader::LichenMap& map, int mip);

/// The share of the variance that a level >= 0 keeps: a trilinear blend of a mip and its own
/// average.
[[nodiscard]] float levelKept(const shader::LichenMap& map, float level);

/// Likewise of textons, interpolated between the texels of a mip: lichenTextonKept.
[[nodiscard]] float textonKept(const shader::LichenMap& map, float level);

} // namespace lichen
