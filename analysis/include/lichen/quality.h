// SPDX-License-Identifier: MIT
// How far a synthesized result is from its exemplar, and what gives it away as synthesized.
//
// Images have 1 to 4 channels of finite values; alpha is ignored, and "luminance" is that of
// spectrum.h, of the stored code values. Every measure is deterministic: the same bytes for any
// number of threads. All are thread-safe.
// Errors: badInput, naming sizes and channels, for images without pixels or too small for the
// measure, or of unlike channels; usage for a parameter outside its range; resources when memory
// does not suffice.
#pragma once

#include <lichen/image.h>
#include <lichen/lattice.h>
#include <lichen/result.h>

#include <cstdint>

namespace lichen {

/// Sliced Wasserstein-2 distance between the two sets of pixel colours, in units of the code value:
/// the root mean square, over 256 fixed directions (1 for grey), of the one-dimensional
/// Wasserstein-2 distance of the projections. 0 for equal sets, whatever their order and size;
/// a shift by a vector of length d gives d / sqrt(3) for colours and d for grey. Projections are
/// rounded to 2^16 steps, so that values below 3e-5 mean nothing. O(256 pixels).
/// Source: [RPDB12].
[[nodiscard]] Result<double> colorDistance(const SrgbImage& exemplar, const SrgbImage& result);

/// Root mean square difference in decibels of the radially averaged power spectra of the
/// luminance (radialPowerSpectrum), from 4 cycles per crop to Nyquist, crops of an even side of at
/// most 128 pixels and a quarter of the shortest of all sides. Powers below that of rounding to 8
/// bits count as that. Sides at least 32.
[[nodiscard]] Result<double> spectrumDistanceDb(const SrgbImage& exemplar, const SrgbImage& result);

/// L2 distance between the normalised autocovariances of the luminance at the lags inside a square
/// support, relative to the norm of the exemplar's: 0 for equal second-order structure. An image
/// without variance has an autocovariance of 0; 1 when only the exemplar has none.
/// supportPixels in [2, a quarter of the shortest of all sides].
[[nodiscard]] Result<double> autocovarianceError(const SrgbImage& exemplar, const SrgbImage& result,
                                                 int supportPixels = 32);

/// Where the lattice of a tiling result lies. Pixel (x, y) has its centre at tile position
/// originTiles + (x + 1/2, y + 1/2) * tilesPerPixel, y downwards.
struct LatticeView {
  Lattice lattice;
  double tilesPerPixelX = 0.0; ///< > 0
  double tilesPerPixelY = 0.0; ///< > 0
  double originTilesX = 0.0;   ///< below 2^30 in magnitude
  double originTilesY = 0.0;
};

/// How much the contrast follows the lattice: squared deviations of the luminance from its mean are
/// averaged in 8 classes of equal population of the distance, in tiles, to the nearest lattice
/// vertex; (largest - smallest) / mean. Its expectation is 0 only for an infinite stationary
/// result: compare with stationaryLatticeVisibility. 0 for an image without variance.
/// The view must show at least 64 pixels.
[[nodiscard]] Result<double> latticeVisibility(const SrgbImage& result, const LatticeView& view);

/// What latticeVisibility finds by chance in a stationary image of the same size and spectrum: the
/// given quantile over phase-randomized results. `trials` in [1, 10000], `quantile` in (0, 1].
/// About two transforms of the image a trial; deterministic.
[[nodiscard]] Result<double> stationaryLatticeVisibility(const SrgbImage& result,
                                                         const LatticeView& view, int trials = 100,
                                                         double quantile = 0.95);

/// A periodic image of the same mean, spectrum and cross-spectra and otherwise random: one random
/// phase per frequency, the same in all channels. Values are not clamped; alpha is dropped.
/// Source: [GGM11].
[[nodiscard]] Result<SrgbImage> phaseRandomized(const SrgbImage& image, std::uint32_t seed);

/// How much more straight edges a result has than its exemplar: first differences of the luminance
/// across rows and columns, averaged over runs of 48 pixels along them; the 99.9th percentile of
/// their absolute value, result over exemplar. About 1 where no seam was added. A seam must take up
/// more than 0.1 % of the rows and columns to count. Percentiles are taken as at least one code
/// step of 8 bits in one pixel of the run. Sides at least 49.
[[nodiscard]] Result<double> seamVisibility(const SrgbImage& exemplar, const SrgbImage& result);

} // namespace lichen
