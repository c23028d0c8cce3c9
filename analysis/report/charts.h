// SPDX-License-Identifier: MIT
// Charts of the report page, as SVG.
#pragma once

#include <lichen/image.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// The distributions of a channel of two images. The axis runs from 0 to `largest`, which code
/// value 1 stands for.
[[nodiscard]] std::string histogramChart(const SrgbImage& exemplar, const SrgbImage& result,
                                         std::size_t channel, double largest);

/// Returns the side in pixels of the crops from which the spectra of two images are computed. 0 if
/// one image is too small for spectrum_distance_db.
[[nodiscard]] int spectrumCrop(const SrgbImage& a, const SrgbImage& b);

/// A curve of spectrumChart().
struct SpectrumCurve {
  std::string_view kind;     ///< "exemplar", "gaussian" or "result", which choose its look
  std::vector<double> power; ///< decibels by cycles per crop
};

/// The power spectrum of the image's luminance, averaged over directions.
[[nodiscard]] SpectrumCurve spectrumCurve(std::string_view kind, const SrgbImage& image, int crop);

/// Power in decibels over the frequency in cycles per pixel, which runs in octaves. Later curves
/// cover earlier ones.
[[nodiscard]] std::string spectrumChart(std::span<const SpectrumCurve> curves, int crop);

} // namespace lichen
