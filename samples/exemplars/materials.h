// SPDX-License-Identifier: MIT
// The project's own example exemplars: stochastic materials, made by code.
#pragma once

#include <lichen/image.h>

#include <array>

namespace lichen::exemplars {

/// Each makes a square, tileable, opaque RGB exemplar of `sidePixels` a side, in [64, 4096],
/// rounded to 8 bits. Grains, leaves and flakes keep their size in pixels: a smaller side shows
/// less of the material, not a smaller picture of it. The same bytes each time.
[[nodiscard]] SrgbImage granite(int sidePixels);
[[nodiscard]] SrgbImage lichenOnStone(int sidePixels);
[[nodiscard]] SrgbImage moss(int sidePixels);
[[nodiscard]] SrgbImage rust(int sidePixels);
[[nodiscard]] SrgbImage sand(int sidePixels);
[[nodiscard]] SrgbImage terrazzo(int sidePixels);

inline constexpr int kSmallestSide = 64;
inline constexpr int kLargestSide = 4096;

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
