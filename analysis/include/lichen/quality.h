// SPDX-License-Identifier: MIT
// Measures how far a synthesized result is from its exemplar, and what reveals it as synthesized.
//
// Images have 1 to 4 channels of finite values; alpha is ignored. "Luminance" is the luminance of
// spectrum.h, of the stored code values. Every measure is thread-safe and deterministic: the same
// bytes for any number of threads.
// Errors: badInput, naming sizes and channels, for images without pixels, too small for the
// measure, or with different channels; usage for a parameter out of range; resources if memory runs
// out.
#pragma once

#include <lichen/image.h>
#include <lichen/lattice.h>
#include <lichen/result.h>

#include <cstdint>

namespace lichen {

/// Sliced Wasserstein-2 distance between the two sets of pixel colours, in units of the code value:
/// the root mean square, over 256 fixed directions (1 for grey), of the one-dimensional
/// Wasserstein-2 distance of the projections. Equal sets give 0, whatever their order and size. A
/// shift by a vector of length d gives d / sqrt(3) for colours and d for grey. Projections are
/// rounded to 2^16 steps, so results below 3e-5 mean nothing. O(256 pixels). Source: [RPDB12].
[[nodiscard]] Result<double> colorDistance(const SrgbImage& exemplar, const SrgbImage& result);

/// Root mean square difference, in decibels, of the radially averaged power spectra of the
/// luminance (radialPowerSpectrum()), from 4 cycles per crop to Nyquist. Crops have an even side of
/// at most 128 pixels and a quarter of the shortest side of both images. Powers below the power of
/// rounding to 8 bits are raised to it. Sides must be at least 32.
[[nodiscard]] Result<double> spectrumDistanceDb(const SrgbImage& exemplar, const SrgbImage& result);

/// L2 distance between the normalised autocovariances of the luminance at the lags inside a square
/// support, relative to the norm of the exemplar's. Equal second-order structure gives 0. An image
/// without variance has an autocovariance of 0; the result is 1 if only the exemplar has none.
/// supportPixels lies in [2, a quarter of the shortest side of both images].
[[nodiscard]] Result<double> autocovarianceError(const SrgbImage& exemplar, const SrgbImage& result,
                                                 int supportPixels = 32);

/// The position of a tiling result's lattice. The centre of pixel (x, y) has the tile position
/// originTiles + (x + 1/2, y + 1/2) * tilesPerPixel, y downwards.
struct LatticeView {
  Lattice lattice;
  double tilesPerPixelX = 0.0; ///< > 0
  double tilesPerPixelY = 0.0; ///< > 0
  double originTilesX = 0.0;   ///< below 2^30 in magnitude
  double originTilesY = 0.0;
};

/// Measures how much the contrast follows the lattice. Squared deviations of the luminance from its
/// mean are averaged in 8 equally populated classes of the distance to the nearest lattice vertex,
/// measured where the triangles are equilateral; the result is (largest - smallest) / mean. Its
/// expectation is 0 only for an infinite stationary result. 0 for an image without variance. The
/// view must show at least 64 pixels.
[[nodiscard]] Result<double> latticeVisibility(const SrgbImage& result, const LatticeView& view);

/// Measures how many more straight edges a result has than its exemplar. First differences of the
/// luminance across rows and columns are averaged over runs of 48 pixels along them; the result is
/// the 99.9th percentile of their absolute values, result over exemplar. About 1 if no seam was
/// added. Only seams in more than 0.1 % of the rows and columns count. Percentiles are at least one
/// 8-bit code step in one pixel of the run. Sides must be at least 49.
[[nodiscard]] Result<double> seamVisibility(const SrgbImage& exemplar, const SrgbImage& result);

} // namespace lichen
