// SPDX-License-Identifier: MIT
// How far tiling with 8-bit tables may be from the oracle on a device whose sampler filters in 8
// bits: standard deviations of a fetch and of a map's value.
#pragma once

#include "synthetic_noise.h"
#include "tiling_reference.h"

#include <array>

namespace lichen::test {

/// Of one fetch of the Gaussian image.
[[nodiscard]] double fetchDeviation();

/// The deviation of a value's channels: those of the Gaussian channels and of the lost variance,
/// each times the value's derivative, and the table's own.
[[nodiscard]] std::array<double, 4> valueDeviation(const TilingReference& reference,
                                                   const SyntheticMap& map,
                                                   const TilingReference::Sample& sample,
                                                   double contrast);

/// The 99 % quantile of the magnitude of a Gaussian of deviation 1. Sums of as many rounding errors
/// have no more.
inline constexpr double kQuantile99 = 2.576;

} // namespace lichen::test
