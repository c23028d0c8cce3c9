// SPDX-License-Identifier: MIT
// Small bundles for the tests and for the extension's examples.
#pragma once

#include <lichen/bundle_writer.h>

namespace lichen::example {

/// A table whose texels follow a fixed pattern.
[[nodiscard]] Table patternTable(const std::string& name, TexelFormat format, std::uint32_t width,
                                 std::uint32_t height, std::uint32_t depth,
                                 std::uint32_t mipLevels);
[[nodiscard]] std::uint32_t fullMipChain(std::uint32_t width, std::uint32_t height);

/// A Gaussian image of pattern texels with a full mip chain; the loss of level l is l over the
/// number of levels.
[[nodiscard]] Table gaussianTable(const std::string& name, TexelFormat format, std::uint32_t width,
                                  std::uint32_t height);
/// A square image of one value with a full mip chain.
[[nodiscard]] Table constantTable(TexelFormat format, std::uint32_t side, float value);
/// Sets one channel of all texels of each mip level.
void setChannel(Table& table, std::size_t channel, const std::vector<float>& valueOfLevel);
/// The same of the last channel.
void setLosses(Table& gaussian, const std::vector<float>& losses);

/// A 2-D table of half floats, 8 x 4 with a full mip chain.
[[nodiscard]] Table tableWithMips();

/// One height map of one channel: 4 x 2 texels and a table of 256 cells. About 3 KB as a GLB.
[[nodiscard]] BundleFile smallest();

/// Two noises and a preview scene. The first noise is the smallest; the second has base colour (D =
/// 3), normal (D = 2), occlusion-roughness-metallic (D = 1), opacity (without an inverse table) and
/// emissive (grey, D = 1).
[[nodiscard]] BundleFile everyMap();

/// One height map as a texton: 8 x 8 coefficients, half a sine period along each axis, in 10 x 10
/// texels with two mips, and the variance that they produce. About 2 KB as a GLB.
[[nodiscard]] BundleFile smallestTexton();

/// Two noises: the smallest, and textons of two exemplars in three steps, with 9 x 17 coefficients
/// for base colour, normal (whose texton has one channel too many) and height.
[[nodiscard]] BundleFile textonMix();

/// One height map as local random-phase noise: four cosines in octaves 0 and 2, with two variants
/// each. About 2 KB as a GLB.
[[nodiscard]] BundleFile smallestCosines();

/// One height map as multiple-kernels noise: two kernels, the second a ring. About 2 KB as a GLB.
[[nodiscard]] BundleFile smallestKernels();
/// The same as an occlusion in two layers that are alike, and their index map: noises 0, 1 and 2.
[[nodiscard]] BundleFile layered();
/// The smallest with cosines, a structure and a list of three offsets.
[[nodiscard]] BundleFile smallestStructure();

/// A height and a normal map of 4 x 4 texels as quilting: cells of 2 x 2 texels, and four offsets
/// that move them onto one another. Their image is the first table. About 3 KB as a GLB.
[[nodiscard]] BundleFile smallestQuilting();

/// A valid PNG of 2 x 2 texels in one colour.
[[nodiscard]] std::vector<std::byte> tinyPng();

} // namespace lichen::example
