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

  /// The value at the frequency (x, y), and in `slopes` its derivatives.
  double at(double x, double y, std::array<double, 2>& slopes) const {
    return valueAt(spectrum_, x, y, slopes);
  }

  /// integral w^2 cos(2 pi (x p + y q)) / integral w^2: at twice the frequency of a cosine, what
  /// its square adds to half the energy of the window.
  double overlap(double x, double y, std::array<double, 2>& slopes) const {
    return valueAt(overlap_, x, y, slopes);
  }

private:
  /// A function of a square, by linear interpolation.
  struct Profile {
    std::vector<double> values;
    [[nodiscard]] double at(double square, double& slope) const;
  };

  double valueAt(const Profile& profile, double x, double y, std::array<double, 2>& slopes) const;

  Window window_;
  Profile spectrum_, overlap_;
};

/// The parameters of a kernel by which densities are differentiated: the logarithm of the energy,
/// the two frequencies, the logarithms of both stretches, the shear.
inline constexpr std::size_t kKernelParameters = 6;
using KernelSlopes = std::array<double, kKernelParameters>;

/// The power at the frequency (u, v) [cycles / tile]: its integral over all frequencies is the
/// energy. `slopes`, unless null: its derivatives. Not for rings.
[[nodiscard]] double densityAt(const WindowSpectrum& spectrum, const Kernel& kernel, double u,
                               double v, KernelSlopes* slopes = nullptr);

/// The same of a ring, which depends on the length of the frequency only.
[[nodiscard]] double ringDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel,
                                   double frequency);

} // namespace lichen::multiple_kernels
