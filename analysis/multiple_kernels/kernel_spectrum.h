// SPDX-License-Identifier: MIT
// The power spectral densities of the noises of kernels.
#pragma once

#include "kernel.h"

#include <array>
#include <vector>

namespace lichen::multiple_kernels {

/// The spectrum of a window, normalised to the energy 1: of the Gabor a function of the squared
/// length of the frequency, of the others a product of functions of its two squares. Frequencies in
/// cycles per unit of the window's coordinates.
class WindowSpectrum {
public:
  /// Throws std::bad_alloc. About 10 ms.
  explicit WindowSpectrum(Window window);

  [[nodiscard]] Window window() const { return window_; }

  /// The power at frequencies beyond this length is below a millionth of the highest, but for the
  /// windows on the square.
  [[nodiscard]] double reach() const { return window_ == Window::gabor ? 3.0 : 12.0; }

  /// The value at the frequency (x, y), and in `slopes` its derivatives.
  double at(double x, double y, std::array<double, 2>& slopes) const {
    return valueAt(spectrum_, x, y, slopes);
  }

private:
  /// A function of a square, by linear interpolation.
  struct Profile {
    std::vector<double> values;
    [[nodiscard]] double at(double square, double& slope) const;
  };

  double valueAt(const Profile& profile, double x, double y, std::array<double, 2>& slopes) const;

  Window window_;
  Profile spectrum_;
};

/// The parameters of a kernel by which densities are differentiated: the logarithm of the energy,
/// the two frequencies, the logarithms of both stretches, the shear.
inline constexpr std::size_t kKernelParameters = 6;
using KernelSlopes = std::array<double, kKernelParameters>;

/// The power at the frequency (u, v) [cycles / tile]: its integral over all frequencies is the
/// energy. `slopes`, unless null: its derivatives. Not for rings.
[[nodiscard]] double densityAt(const WindowSpectrum& spectrum, const Kernel& kernel, double u,
                               double v, KernelSlopes* slopes = nullptr);

/// As densityAt() of a ring, which depends on the length of the frequency only.
[[nodiscard]] double ringDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel,
                                   double frequency);

/// The power at a frequency of the plane where the noise is sampled once in each of `texels` x
/// `texels` texels of a tile: with that of the frequencies that are then the same. `slopes`: not of
/// rings.
[[nodiscard]] double sampledDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel,
                                      const std::array<double, 2>& texels, double u, double v,
                                      KernelSlopes* slopes = nullptr);

} // namespace lichen::multiple_kernels
