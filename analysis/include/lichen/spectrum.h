// SPDX-License-Identifier: MIT
// Second-order statistics of image planes: power and cross-spectra, covariances.
//
// A plane is width * height floats, row-major, row 0 at the top. Building blocks of the analysis:
// std::bad_alloc passes through them. Same bytes for any number of threads.
#pragma once

#include <lichen/fft.h>
#include <lichen/image.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen {

/// Of red, green and blue: Rec. ITU-R BT.709, item 3.2.
inline constexpr std::array<float, 3> kLuminanceWeights{0.2126f, 0.7152f, 0.0722f};

/// The luminance of the stored code values, as an eye sees them: Rec. 709 weights for 3 or 4
/// channels, the grey channel for 1 or 2. Alpha is ignored.
[[nodiscard]] std::vector<float> luminancePlane(const SrgbImage& image);

/// The plane less a smooth one, so that opposite borders fit together: the periodic component,
/// whose spectrum has not the cross that the jump between opposite borders makes. Same mean.
/// Source: [M11].
[[nodiscard]] std::vector<float> periodicComponent(std::span<const float> plane, int width,
                                                   int height);

/// The cross-spectrum of two planes of one size from their transforms: conj(a^) b^ over the number
/// of pixels. Its inverse transform is, at each lag v, the mean over the pixels x of a(x) b(x + v),
/// borders joined.
[[nodiscard]] HalfSpectrum crossSpectrum(const HalfSpectrum& a, const HalfSpectrum& b);

/// The power spectrum of a plane from its transform, |a^|^2 over the number of pixels, in the order
/// of HalfSpectrum::values. White noise of variance s has power s throughout; each value scatters
/// by as much as its mean.
[[nodiscard]] std::vector<float> powerSpectrum(const HalfSpectrum& plane);

/// Radially averaged power spectrum, averaged over square, Hann-windowed, half-overlapping crops
/// of `cropSide` pixels [W67]. Element r, r in [0, cropSide / 2], is the mean power of the
/// frequencies whose radius in cycles per crop rounds to r; white noise of variance s has power s
/// throughout. Crops start at multiples of cropSide / 2; a rest too small for a crop is left out.
/// cropSide even, in [2, min(width, height)]. The window spreads the mean over r = 0 and 1 only.
[[nodiscard]] std::vector<double> radialPowerSpectrum(std::span<const float> plane, int width,
                                                      int height, int cropSide);

/// Side of the crops in which spectra of two images are compared: even, at most 128 pixels, and at
/// most a quarter of the shortest of all sides, since fewer crops are one crop's chance.
[[nodiscard]] constexpr int comparedCropSide(int shortestSide) {
  constexpr int kLargestCrop = 128;
  constexpr int kCropsPerSide = 4;
  const int side = shortestSide / kCropsPerSide;
  return (side < kLargestCrop ? side : kLargestCrop) / 2 * 2;
}
/// The lowest frequency compared, in cycles per crop: below it the window mixes too much.
inline constexpr int kLowestComparedCycles = 4;

/// Autocovariance at the lags inside a support of `support` pixels a side: element
/// (dy + support - 1) * (2 support - 1) + dx + support - 1 for |dx|, |dy| < support, each the mean
/// over the pairs of pixels that the plane holds (nothing wraps), so that planes of different
/// sizes can be compared. support in [1, min(width, height)]. Computed by zero-padded FFT.
[[nodiscard]] std::vector<double> autocovariance(std::span<const float> plane, int width,
                                                 int height, int support);

/// A periodic plane of the same mean and power spectrum with random phases, the same phase at the
/// same frequency for the same seed, so that planes of several channels keep their cross-spectra.
/// Source: [GGM11].
[[nodiscard]] std::vector<float> phaseRandomizedPlane(const HalfSpectrum& spectrum,
                                                      std::uint32_t seed);

} // namespace lichen
