// SPDX-License-Identifier: MIT
// The image of an exemplar's Gaussian values, with its mip levels.
#pragma once

#include <lichen/table.h>

#include <vector>

namespace lichen {

/// What a Gaussian image holds in place of the mean 1/2: a value of 8-bit texels, so that coarse
/// mip levels, which hold little else, are not rounded away from it.
inline constexpr float kStoredGaussianMean = 128.0f / 255.0f;

/// The last channel of each mip level of a Gaussian image: the share of the variance that a fetch
/// of the level loses, interpolation between texels included. In [0, 1], never decreasing.
[[nodiscard]] std::vector<float> fetchLosses(const Table& gaussian);

} // namespace lichen
