// SPDX-License-Identifier: MIT
// The discrete Fourier transform of real images of any size.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace lichen {

/// The non-redundant half of the transform of a real image. The coefficient of frequency (u, v) in
/// cycles per image, u in [0, width / 2], v in [0, height), is values[v * columns() + u]. A v above
/// height / 2 stands for v - height; (-u, -v) is the complex conjugate of (u, v).
struct HalfSpectrum {
  int width = 0;  ///< of the image
  int height = 0; ///< of the image
  std::vector<std::complex<float>> values;

  [[nodiscard]] int columns() const { return width / 2 + 1; }
  [[nodiscard]] std::complex<float>& at(int u, int v) {
    return values[std::size_t(v) * std::size_t(columns()) + std::size_t(u)];
  }
  [[nodiscard]] const std::complex<float>& at(int u, int v) const {
    return values[std::size_t(v) * std::size_t(columns()) + std::size_t(u)];
  }
  /// Returns the frequency of row v in cycles per image, in (-height / 2, height / 2].
  [[nodiscard]] int signedRow(int v) const { return v <= height / 2 ? v : v - height; }
  /// Returns how many columns of the full plane column u stands for: 1 if it is its own mirror.
  [[nodiscard]] int multiplicity(int u) const { return u == 0 || 2 * u == width ? 1 : 2; }
};

/// Computes sum over (x, y) of plane[y * width + x] exp(-2 pi i (u x / width + v y / height)), not
/// normalised. Width and height are at least 1 and may be prime. The plane may end after any row:
/// the rows that it lacks are 0, and FFTW does not transform them. The error is about 1e-7 times
/// the square root of the plane's energy times log2 of its size. Deterministic and thread-safe.
/// Throws std::bad_alloc, as all building blocks of the analysis do; functions that return a Result
/// convert it to an Error. The build option LICHEN_FFT selects the backend: FFTW [FJ05] or KissFFT.
[[nodiscard]] HalfSpectrum forwardFft(std::span<const float> plane, int width, int height);

/// Computes the inverse, divided by width * height: inverseFft(forwardFft(p)) is p up to rounding.
/// Ignores the imaginary parts of coefficients that are their own mirror. Returns the plane's first
/// rows, of 1 to height; FFTW does not transform the others.
[[nodiscard]] std::vector<float> inverseFft(const HalfSpectrum& spectrum, int rows);
[[nodiscard]] inline std::vector<float> inverseFft(const HalfSpectrum& spectrum) {
  return inverseFft(spectrum, spectrum.height);
}

/// Returns the smallest number >= `size` without a prime factor above 5: such transforms are fast.
/// `size` must be at least 1.
[[nodiscard]] int fastTransformSize(int size);

} // namespace lichen
