// SPDX-License-Identifier: MIT
// Members of a map's constants that methods fill in the same form.
#pragma once

#include <lichen/shader_parameters.h>

#include <cstddef>
#include <span>
#include <vector>

namespace lichen {

/// Size, dimensions and mips of the image that the shader fetches.
void setImage(shader::LichenMap& constants, const Table& image);

/// Rows of an n x d matrix (row-major) and an offset of n values; what is absent is 0.
void setRows(shader::LichenMap& constants, const std::vector<double>& matrix,
             std::size_t dimensions, const std::vector<double>& offset);

/// sqrt(1 - loss) of each mip as unorm bytes, the first in the lowest byte of x; the last repeats.
[[nodiscard]] shader::uvec4 keptAmplitudes(std::span<const double> losses);

/// Sets the mean of the decoded values, for maps without a table.
void setGaussianMean(shader::LichenMap& constants);

} // namespace lichen
