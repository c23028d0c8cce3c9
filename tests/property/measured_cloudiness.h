// SPDX-License-Identifier: MIT
// Cloudiness as an eye sees it, by the tables of a bake.
#pragma once

#include <lichen/image.h>
#include <lichen/tiling.h>

#include <vector>

namespace lichen::test {

/// The image as the map of base colours that it is, RGB.
[[nodiscard]] MapExemplar baseColor(const SrgbImage& image);

[[nodiscard]] double mean(const std::vector<double>& values);
[[nodiscard]] double variance(const std::vector<double>& values);

/// Relative standard deviation, over `samples` random offsets of three equally weighted taps, of
/// the variance of the blended, decoded luminance over the whole tile. The map tiles and has three
/// dimensions of colour.
[[nodiscard]] double measuredCloudiness(const MapExemplar& map, int samples);

} // namespace lichen::test
