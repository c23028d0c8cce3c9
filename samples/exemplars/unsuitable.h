// SPDX-License-Identifier: MIT
// Pictures whose noise disappoints, each in its own way, made by code.
//
// Bare numbers are appearance, as in materials.h: colours in sRGB code values, lengths in
// pixels, and seeds.
#pragma once

#include <lichen/image.h>

#include <array>

namespace lichen::exemplars {

/// Each makes a square RGB picture of `sidePixels` a side, rounded to 8 bits; the same bytes each
/// time.
[[nodiscard]] SrgbImage bricks(int sidePixels);       ///< running bond, mortar between; tileable
[[nodiscard]] SrgbImage planks(int sidePixels);       ///< grained boards side by side
[[nodiscard]] SrgbImage weave(int sidePixels);        ///< plain weave of even threads; tileable
[[nodiscard]] SrgbImage paving(int sidePixels);       ///< large stones with dark joints; tileable
[[nodiscard]] SrgbImage text(int sidePixels);         ///< lines of letters on paper
[[nodiscard]] SrgbImage oneStone(int sidePixels);     ///< a pale stone on dark gravel; tileable
[[nodiscard]] SrgbImage slopingLight(int sidePixels); ///< sand lit from one side
[[nodiscard]] SrgbImage vignette(int sidePixels);     ///< sand, darker to the corners
[[nodiscard]] SrgbImage overexposed(int sidePixels);  ///< granite, a third of it white; tileable
[[nodiscard]] SrgbImage carpet(int sidePixels);       ///< fibres, worn in clouds; tileable
[[nodiscard]] SrgbImage wood(int sidePixels);         ///< fine grain in broad dark bands

struct Unsuitable {
  const char* name; ///< also the file's, without .png
  SrgbImage (*generate)(int sidePixels);
  bool periodic;
  const char* risk; ///< the one to be found severe
};

inline constexpr std::array<Unsuitable, 11> kUnsuitable{{
    {"bricks", bricks, true, "structure"},
    {"planks", planks, false, "structure"},
    {"weave", weave, true, "structure"},
    {"paving", paving, true, "structure"},
    {"text", text, false, "structure"},
    {"one_stone", oneStone, true, "low-frequency"},
    {"sloping_light", slopingLight, false, "low-frequency"},
    {"vignette", vignette, false, "low-frequency"},
    {"overexposed", overexposed, true, "clipping"},
    {"carpet", carpet, true, "cloudiness"},
    {"wood", wood, false, "cloudiness"},
}};

} // namespace lichen::exemplars
