// SPDX-License-Identifier: MIT
// The discrete Fourier transform of real images of any size.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace lichen {

/// The non-redundant half of the transform of a real image: the coefficient of frequency (u, v) in
/// cycles per image, u in [0, width / 2], v in [0, height), is values[v * columns() + u]; v above
/// height / 2 stands for v - height, and (-u, -v) is the complex conjugate of (u, v).
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
  /// The frequency of row v in cycles per image, in (-height / 2, height / 2].
  [[nodiscard]] int signedRow(int v) const { return v <= height / 2 ? v : v - height; }
  /// How many frequencies of the full plane column u stands for: 1 where it is its own mirror.
  [[nodiscard]] int multiplicity(int u) const { return u == 0 || 2 * u == width ? 1 : 2; }
};

/// sum over (x, y) of plane[y * width + x] exp(-2 pi i (u x / width + v y / height)), not
/// normalised. Width and height at least 1, primes included; the plane holds width * height values.
/// Error about 1e-7 of the root of the plane's energy times log2 of its size.
/// Same input, same bytes. Thread-safe. Throws std::bad_alloc, as every building block of the
/// analysis does; functions that return a Result turn it into one.
/// The backend is FFTW [FJ05] or KissFFT, by the build option LICHEN_FFT.
[[nodiscard]] HalfSpectrum forwardFft(std::span<const float> plane, int width, int height);

/// The inverse, divided by width * height: inverseFft(forwardFft(p)) is p up to rounding. Imaginary
/// parts of coefficients that are their own mirror are ignored.
[[nodiscard]] std::vector<float> inverseFft(const HalfSpectrum& spectrum);

/// The least size, at least `size` >= 1, without a prime factor above 5: those transform fast.
[[nodiscard]] int fastTransformSize(int size);

/// Many transforms between half spectra of width x height and the same patch of the plane, of which
/// all the rest is zero (forward) or not asked for (inverse): plans and buffers are made once, and
/// the rows outside the patch cost nothing. Not thread-safe: one object a thread.
class PatchFft {
public:
  /// The patch is the plane's first patchWidth x patchHeight pixels, at least 1 x 1 and at most
  /// width x height. Throws std::bad_alloc; the transforms do not, and allocate nothing but what
  /// KissFFT takes for sizes with a prime factor above 5.
  PatchFft(int width, int height, int patchWidth, int patchHeight);
  PatchFft(PatchFft&&) noexcept;
  PatchFft& operator=(PatchFft&&) noexcept;
  ~PatchFft();

  /// forwardFft of the plane, to rounding. `patch` holds patchWidth * patchHeight values row by
  /// row; `spectrum` has the constructor's width and height.
  void forward(std::span<const float> patch, HalfSpectrum& spectrum);
  /// The patch of inverseFft(spectrum), to rounding.
  void inverse(const HalfSpectrum& spectrum, std::span<float> patch);

private:
  std::unique_ptr<class PatchTransform> transform_;
};

} // namespace lichen
