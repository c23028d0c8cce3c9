// SPDX-License-Identifier: MIT
// The number of impacts in a cell of a Poisson process: the CPU twin of
// shaders_glsl/noise/poisson_count.glsl.
#pragma once

#include <cstdint>

namespace lichen {

/// The quantile of a Poisson variable of mean 1 at hash / 2^32.
[[nodiscard]] int poissonCount(std::uint32_t hash);

} // namespace lichen
