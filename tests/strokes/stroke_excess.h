// SPDX-License-Identifier: MIT
// How much more a picture consists of strokes than chance makes of its spectrum.
#pragma once

#include <lichen/image.h>

namespace lichen::test {

/// What strokeExcess() measures.
struct StrokeExcess {
  double value = 0.0;
  double standardError = 0.0; ///< of the value of an image with random phases
};

/// Measures how much more a result consists of strokes than chance makes of its spectrum: short
/// parallel waves, as too few cosines at a place leave. In the bands of an octave around 2.83, 5.66
/// and 11.3 pixels, the coherence of the structure tensor, averaged over a Gaussian of one
/// wavelength [BG87], is compared with its mean over `trials` phase-randomized images with the same
/// histogram; the value is the relative excess, averaged over the bands by their variance. The
/// luminance's periodic component is first replaced by normal values of the same ranks. 0 for
/// random phases, with a standard error of about 0.01 at 512 x 512; negative for images whose
/// gradients have less of a common direction. Bands with less than 3 % of the variance do not
/// count; 0 if none does. Sides are at least 64, `trials` at least 2. Takes about 25
/// transforms of the image per trial; deterministic.
[[nodiscard]] StrokeExcess strokeExcess(const SrgbImage& result, int trials = 40);

} // namespace lichen::test
