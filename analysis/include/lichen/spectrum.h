// SPDX-License-Identifier: MIT
// Second-order statistics of image planes: power spectra, cross-spectra and covariances.
//
// A plane is width * height floats, row-major, row 0 at the top. These are building blocks of the
// analysis: they throw std::bad_alloc. Same bytes for any number of threads.
#pragma once

#include <lichen/fft.h>
#include <lichen/image.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen {

/// For red, green and blue: Rec. ITU-R BT.709, item 3.2.
inline constexpr std::array<float, 3> kLuminanceWeights{0.2126f, 0.7152f, 0.0722f};

/// Returns the luminance of the stored code values, as the eye perceives them: Rec. 709 weights for
/// 3 or 4 channels, the grey channel for 1 or 2. Ignores alpha.
[[nodiscard]] std::vector<float> luminancePlane(const SrgbImage& image);

/// Returns the periodic component: the plane minus a smooth one, so that opposite borders match and
/// the spectrum loses the cross that the jump between them makes. The mean does not change.
/// Source: [M11].
[[nodiscard]] std::vector<float> periodicComponent(std::span<const float> plane, int width,
                                                   int height);

/// Computes the cross-spectrum of two planes of the same size from their transforms: conj(a^) b^
/// over the number of pixels. Its inverse transform at lag v is the mean over the pixels x of
/// a(x) b(x + v), with wrapped borders.
[[nodiscard]] HalfSpectrum crossSpectrum(const HalfSpectrum& a, const HalfSpectrum& b);

/// Computes the power spectrum of a plane from its transform: |a^|^2 over the number of pixels, in
/// the order of HalfSpectrum::values. White noise of variance s has power s at all frequencies; the
/// standard deviation of each value equals its mean.
[[nodiscard]] std::vector<float> powerSpectrum(const HalfSpectrum& plane);

/// Computes the radially averaged power spectrum, averaged over square, Hann-windowed,
/// half-overlapping crops of `cropSide` pixels [W67]. Element r, r in [0, cropSide / 2], is the
/// mean power of all frequencies (u, v), in cycles per crop, with round(sqrt(u^2 + v^2)) = r. White
/// noise of variance s has power s at all r. Crops start at multiples of cropSide / 2; a remainder
/// too small for a crop is skipped. cropSide is even, in [2, min(width, height)]. The window
/// spreads the mean over r = 0 and 1 only.
[[nodiscard]] std::vector<double> radialPowerSpectrum(std::span<const float> plane, int width,
                                                      int height, int cropSide);

/// Side of the crops for comparing the spectra of two images: even, at most 128 pixels and at most
/// a quarter of the shortest side of both, since a mean over fewer crops depends on chance.
[[nodiscard]] constexpr int comparedCropSide(int shortestSide) {
  constexpr int kLargestCrop = 128;
  constexpr int kCropsPerSide = 4;
  const int side = shortestSide / kCropsPerSide;
  return (side < kLargestCrop ? side : kLargestCrop) / 2 * 2;
}
/// The lowest frequency to compare, in cycles per crop: below it the window mixes too much.
inline constexpr int kLowestComparedCycles = 4;

/// Computes the autocovariance at the lags inside a support of `support` pixels per side. Lag
/// (dx, dy), |dx|, |dy| < support, is element (dy + support - 1) * (2 support - 1) + dx + support -
/// 1: the mean over all pairs of pixels inside the plane. Nothing wraps, so planes of different
/// sizes are comparable. support in [1, min(width, height)]. Uses a zero-padded FFT.
[[nodiscard]] std::vector<double> autocovariance(std::span<const float> plane, int width,
                                                 int height, int support);

/// Returns a periodic plane with the same mean and power spectrum and with random phases. The same
/// seed gives the same phase at the same frequency, so planes of several channels retain their
/// cross-spectra. Source: [GGM11].
[[nodiscard]] std::vector<float> phaseRandomizedPlane(const HalfSpectrum& spectrum,
                                                      std::uint32_t seed);

} // namespace lichen
