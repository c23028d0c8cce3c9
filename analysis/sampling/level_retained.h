// SPDX-License-Identifier: MIT
// The share of a map's variance that remains in the mips of its image: the CPU twin of
// shaders_glsl/noise/mip_variance.glsl.
#pragma once

#include <lichen_interface.h>

namespace lichen {

/// Returns the kept amplitude of a mip: the amplitude of its texels relative to the Gaussian value.
/// `bytes` are those of one channel, such as LichenMap::mipRetained0.
[[nodiscard]] float mipRetained(const shader::uvec4& bytes, int mip);

/// Returns the share of the variance that remains at a level >= 0 of a Gaussian image, for a
/// trilinear blend of a mip and its own average.
[[nodiscard]] float levelRetained(const shader::LichenMap& map, float level);

} // namespace lichen
