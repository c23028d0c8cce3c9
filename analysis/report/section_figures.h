// SPDX-License-Identifier: MIT
// Pictures and curves that the sections of the report page share.
#pragma once

#include <lichen/image.h>

#include <array>
#include <vector>

namespace lichen {

using Extents = std::array<int, 2>; ///< width and height

/// The size of the picture of width x height pixels: their proportions, and at most side^2 pixels.
[[nodiscard]] Extents pictureExtents(int width, int height, int side);

/// The image with at most its own width and height; each pixel is the mean of the block of pixels
/// under it.
[[nodiscard]] SrgbImage reduced(const SrgbImage& image, int width, int height);
[[nodiscard]] LinearImage reduced(const LinearImage& image, int width, int height);

/// Returns the side in pixels of the crops from which the spectra of two images are computed. 0 if
/// one image is too small for spectrum_distance_db.
[[nodiscard]] int spectrumCrop(const SrgbImage& a, const SrgbImage& b);

/// Power spectrum of the luminance in decibels by cycles per crop, averaged over directions.
[[nodiscard]] std::vector<double> decibels(const SrgbImage& image, int crop);

} // namespace lichen
