// SPDX-License-Identifier: MIT
// Sets members of a map's constants that several methods share.
#pragma once

#include <lichen/shader_parameters.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lichen {

/// Sets the size, dimensions and mip count of the image that the shader fetches.
void setImage(shader::LichenMap& constants, const Table& image);

/// By how many mip levels an image is larger than a tile of [width, height] texels; negative for a
/// smaller image.
[[nodiscard]] float levelOffset(const Table& image, const std::array<std::uint32_t, 2>& tile);

/// Sets the steps between neighbouring random offsets of a tile.
void setOffsetSteps(shader::LichenNoise& constants);

/// Sets the rows from an n x d matrix (row-major) and an offset of n values. Further matrix columns
/// become 0; further rows stay unchanged.
void setRows(shader::LichenMap& constants, const std::vector<double>& matrix,
             std::size_t dimensions, const std::vector<double>& offset);

/// The retained amplitude sqrt(1 - loss) of each mip level as unorm bytes, the first in the lowest
/// byte of x. The last loss repeats for further levels.
[[nodiscard]] shader::uvec4 retainedAmplitudes(std::span<const double> losses);

/// Sets the rows of a map with an inverse table to the linear part of that: the direction of each
/// by regression, its length by the variance of its channel.
void setLinearRows(shader::LichenMap& constants, const NoiseMap& map, const Table& table);

/// Sets the mean of the decoded values, for maps without an inverse table.
void setGaussianMean(shader::LichenMap& constants);

/// Sets how the Gaussian values of a map are decoded: by its inverse table, or by the affine map
/// from mean and covariance.
void setDecoding(shader::LichenMap& constants, const Bundle& bundle, const NoiseMap& map,
                 std::optional<std::size_t> inverseTable);

} // namespace lichen
