// SPDX-License-Identifier: MIT
// Generated pictures that are unsuitable as exemplars, each for a different reason.
//
// Literals are art direction, as in materials.h: colours in sRGB code values, lengths in pixels,
// and seeds.
#pragma once

#include <lichen/image.h>

#include <array>
#include <materials.h>

namespace lichen::exemplars {

/// Each function generates a square RGB picture with `sidePixels` pixels per side, rounded to 8
/// bits. The result is deterministic.
[[nodiscard]] SrgbImage planks(int sidePixels);       ///< grained boards side by side
[[nodiscard]] SrgbImage weave(int sidePixels);        ///< plain weave of even threads; tileable
[[nodiscard]] SrgbImage paving(int sidePixels);       ///< large stones with dark joints; tileable
[[nodiscard]] SrgbImage text(int sidePixels);         ///< lines of letters on paper
[[nodiscard]] SrgbImage oneStone(int sidePixels);     ///< a pale stone on dark gravel; tileable
[[nodiscard]] SrgbImage slopingLight(int sidePixels); ///< sand lit from one side
[[nodiscard]] SrgbImage vignette(int sidePixels);     ///< sand, darker toward the corners
/// granite with a third clipped to white; tileable
[[nodiscard]] SrgbImage overexposed(int sidePixels);
[[nodiscard]] SrgbImage carpet(int sidePixels); ///< fibres with large worn areas; tileable
[[nodiscard]] SrgbImage wood(int sidePixels);   ///< fine grain in broad dark bands

struct Unsuitable {
  const char* name; ///< also the file name without .png
  SrgbImage (*generate)(int sidePixels);
  bool periodic;
  const char* risk; ///< the risk that analysis must rate severe
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
