// SPDX-License-Identifier: MIT
// The project's own example exemplars: stochastic materials, made by code.
//
// The generators' bare numbers are appearance: colours in sRGB code values, lengths in pixels,
// shares and strengths, chosen by eye beside photographs, and seeds.
#pragma once

#include <lichen/image.h>

#include <array>

namespace lichen::exemplars {

inline constexpr int kSmallestSide = 64;
inline constexpr int kLargestSide = 2048; // of which the fields take about 1 GB

/// Each makes a square, tileable, opaque RGB exemplar of `sidePixels` a side, in [kSmallestSide,
/// kLargestSide], rounded to 8 bits. Grains, leaves and flakes keep their size in pixels: a smaller
/// side shows less of the material, not a smaller picture of it. The same bytes each time.
[[nodiscard]] SrgbImage granite(int sidePixels);
[[nodiscard]] SrgbImage lichenOnStone(int sidePixels);
[[nodiscard]] SrgbImage moss(int sidePixels);
[[nodiscard]] SrgbImage rust(int sidePixels);
[[nodiscard]] SrgbImage sand(int sidePixels);
[[nodiscard]] SrgbImage terrazzo(int sidePixels);

struct Material {
  const char* name; ///< also the file's, without .png
  SrgbImage (*generate)(int sidePixels);
};

inline constexpr std::array<Material, 6> kMaterials{{
    {"granite", granite},
    {"lichen_on_stone", lichenOnStone},
    {"moss", moss},
    {"rust", rust},
    {"sand", sand},
    {"terrazzo", terrazzo},
}};

} // namespace lichen::exemplars
