// SPDX-License-Identifier: MIT
// Generated photographs of materials with the faults that photographs have, beside what they would
// be without the fault. None of them tiles. Literals are art direction, as in
// samples/exemplars/materials.h.
#pragma once

#include <lichen/image.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lichen::exemplars {

enum class Fault {
  none,
  vignette, ///< darker toward the corners
  gradient, ///< darker toward one side
  shadow,   ///< a soft shadow over a part
  fold,     ///< one dark crease with a bright edge
  stain,    ///< one darker, yellower spot
  leaf,     ///< one leaf, of another colour
  patches,  ///< slow variation of the material's own colour
};
[[nodiscard]] const char* nameOf(Fault fault);

/// A surface, its fault, and how strong that is: the share of the light that is missing where it is
/// darkest, in [0, 1); for `leaf` 0, since a leaf hides what is below.
struct PhotographPlan {
  const char* material = "";
  Fault fault = Fault::none;
  float strength = 0.0f;
  std::uint32_t seed = 0; ///< places the crop, the light and the object

  [[nodiscard]] std::string name() const; ///< "plaster-vignette-40", "rust-even"
};

/// A pixel rectangle.
struct Place {
  int x = 0, y = 0, width = 0, height = 0;
};

struct Photograph {
  SrgbImage image;
  SrgbImage even; ///< the image without its fault
  Place object;   ///< around the fold, stain or leaf; empty for other faults
};

/// The surface that photographs of this side, in [64, 1024], show a part of.
/// `material` is one of a PhotographPlan in sixtyPhotographs().
[[nodiscard]] SrgbImage photographedSurface(const std::string& material, int sidePixels);

/// Takes a square photograph of two thirds of the surface, of 8 bits with the noise of a camera.
/// Details keep their size in pixels; light and objects are shares of the side. Deterministic.
[[nodiscard]] Photograph photograph(const SrgbImage& surface, const PhotographPlan& plan);

/// Sixty photographs: six each of ten materials, which have no fault, faint and strong uneven
/// light, a shadow, an object, and patches.
[[nodiscard]] std::vector<PhotographPlan> sixtyPhotographs();

} // namespace lichen::exemplars
