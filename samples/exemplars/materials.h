// SPDX-License-Identifier: MIT
// The project's example exemplars: procedurally generated stochastic materials.
//
// Literals in the generators are art direction, chosen by eye next to photographs: colours in sRGB
// code values, lengths in pixels, shares, strengths and seeds.
#pragma once

#include <lichen/image.h>

#include <array>

namespace lichen::exemplars {

inline constexpr int kSmallestSide = 64;
inline constexpr int kLargestSide = 2048; // uses about 1 GB of memory

/// Each function generates a square, tileable, opaque RGB exemplar with `sidePixels` pixels per
/// side, in [kSmallestSide, kLargestSide], rounded to 8 bits. Details keep their size in pixels: a
/// smaller side shows less of the material, not a smaller version of it. The result is
/// deterministic.
[[nodiscard]] SrgbImage granite(int sidePixels);
[[nodiscard]] SrgbImage lichenOnStone(int sidePixels);
[[nodiscard]] SrgbImage moss(int sidePixels);
[[nodiscard]] SrgbImage rust(int sidePixels);
[[nodiscard]] SrgbImage sand(int sidePixels);
[[nodiscard]] SrgbImage terrazzo(int sidePixels);

struct Material {
  const char* name; ///< also the file name without .png
  SrgbImage (*generate)(int sidePixels);
};

/// Bricks in a running bond, which repeat: for quilting. As above.
[[nodiscard]] SrgbImage bricks(int sidePixels);

inline constexpr std::array<Material, 6> kMaterials{{
    {"granite", granite},
    {"lichen_on_stone", lichenOnStone},
    {"moss", moss},
    {"rust", rust},
    {"sand", sand},
    {"terrazzo", terrazzo},
}};

} // namespace lichen::exemplars
