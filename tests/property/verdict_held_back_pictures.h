// SPDX-License-Identifier: MIT
// Pictures for the error rates of the verdict. No threshold was chosen with them.
//
// Each has its own seed, side, colours, sizes and contrast. Whether its noise is good was decided
// for each kind before any was judged, by what a person sees in such a noise.
#pragma once

#include <lichen/image.h>

#include <array>
#include <cstdint>
#include <periodic.h>

namespace lichen::test {

/// Draws a material that tiles, with features of at most a tenth of kSmallestHeldBackSide.
using DrawMaterial = exemplars::Canvas (*)(int sidePixels, exemplars::Random& random);
/// Draws a picture whose noise shows a fault.
using DrawFaulty = SrgbImage (*)(int sidePixels, exemplars::Random& random);

inline constexpr int kSmallestHeldBackSide = 176, kLargestHeldBackSide = 208; // pixels

/// What a bake repairs by default. All but `tiles` are parts of larger pictures.
enum class Condition {
  tiles,
  cropped,
  vignette,
  gradient,   ///< light falls off from one side to the other
  shadow,     ///< its soft edge crosses the picture
  compressed, ///< quantized in blocks, as JPEG is
  noisy,      ///< noise of a camera
  fold,       ///< occurs once, as do the next two
  stain,
  leaf,
};
inline constexpr std::array<const char*, 10> kConditionNames{
    "tiles",      "cropped", "vignette", "gradient", "shadow",
    "compressed", "noisy",   "fold",     "stain",    "leaf"};

struct SoundKind {
  const char* name;
  DrawMaterial draw;
};
struct FaultyKind {
  const char* name;
  DrawFaulty draw;
};

[[nodiscard]] const std::array<SoundKind, 12>& soundKinds();
[[nodiscard]] const std::array<FaultyKind, 15>& faultyKinds();

/// A part of the picture, at a random place.
[[nodiscard]] SrgbImage cropped(const SrgbImage& image, int sidePixels, exemplars::Random& random);

/// A photograph of the material under the condition, of 8 bits.
[[nodiscard]] SrgbImage photographed(DrawMaterial draw, int sidePixels, Condition condition,
                                     exemplars::Random& random);

} // namespace lichen::test
