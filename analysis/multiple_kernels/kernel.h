// SPDX-License-Identifier: MIT
// A kernel of multiple-kernels noise, a window times a wave, thrown at random points with random
// phases, and the power spectral density of its noise. [MKN12] section 3.
#pragma once

#include <lichen/multiple_kernels_map.h>

#include <Eigen/Dense>

#include <array>
#include <vector>

namespace lichen::multiple_kernels {

using Window = KernelWindow;

/// s sqrt(2) cos(2 pi f.d + t pi / 4) w(Q d) at an offset d from its impact [tiles], with signs s
/// and t at random: a wave of four phases. The kernel of a ring has the length of f, and at each
/// impact a direction at random.
struct Kernel {
  double energy = 0.0;               ///< the variance that it adds
  std::array<double, 2> frequency{}; ///< f [cycles / tile]; of a ring, (radius, 0)
  /// Q^-T = (stretch[0], shear; 0, stretch[1]) [tiles]; stretch > 0. Q^-1 takes the unit disk to
  /// the support. Shear is 0 for a ring, and for windows on the square.
  std::array<double, 2> stretch{1.0, 1.0};
  double shear = 0.0;
  bool isRing = false;

  /// Q
  [[nodiscard]] Eigen::Matrix2d toWindow() const;
  /// Half the width and height of the support's bounding box [tiles].
  [[nodiscard]] std::array<double, 2> reach(Window window) const;
  /// The area of the support. [tiles^2]
  [[nodiscard]] double area(Window window) const;
};

/// w at (p, q).
[[nodiscard]] double windowAt(Window window, double p, double q);

/// The mean square frequency of a window along one axis [(cycles per unit of p)^2]: by quadrature,
/// integral (dw/dp)^2 / (4 pi^2 integral w^2).
[[nodiscard]] double windowSpread(Window window);

/// The integral of the square of a kernel, on average over its signs [tiles^2]: the integral of its
/// window.
[[nodiscard]] double squareIntegral(Window window, const Kernel& kernel);

/// The spectrum of a window, normalised to the energy 1: of the Gabor a function of the squared
/// length of the frequency, of the others a product of functions of its two squares. Frequencies in
/// cycles per unit of the window's coordinates.
class WindowSpectrum {
public:
  /// The spectrum is 0 beyond this frequency. Less than 1e-4 of a window's energy lies there; of a
  /// sinc's, more.
  static constexpr double kFarthest = 12.0;

  /// Throws std::bad_alloc. About 10 ms.
  explicit WindowSpectrum(Window window);

  [[nodiscard]] Window window() const { return window_; }

  /// The power at frequencies beyond this length is below a millionth of the highest, but for the
  /// windows on the square.
  [[nodiscard]] double reach() const { return window_ == Window::gabor ? 3.0 : kFarthest; }

  /// The value at the frequency (x, y), and in `slopes` its derivatives.
  double at(double x, double y, std::array<double, 2>& slopes) const {
    if (window_ == Window::gabor) {
      const auto [value, slope] = ofSquare(x * x + y * y);
      slopes = {2.0 * x * slope, 2.0 * y * slope};
      return value;
    }
    const Entry across = ofSquare(x * x), down = ofSquare(y * y);
    slopes = {2.0 * x * across.slope * down.value, 2.0 * y * across.value * down.slope};
    return across.value * down.value;
  }

private:
  static constexpr std::size_t kEntries = 1u << 12; // evenly in the square of the frequency
  static constexpr double kStep = kFarthest * kFarthest / double(kEntries);

  struct Entry {
    double value = 0.0, slope = 0.0; ///< by the square
  };

  /// By Hermite's cubic between the entries.
  [[nodiscard]] Entry ofSquare(double square) const {
    const double place = square / kStep;
    if (!(place < double(kEntries)))
      return {};
    const auto entry = std::size_t(int(place)); // signed: the faster conversion
    const double t = place - double(entry);
    const auto [value, slope] = table_[entry];
    const Entry next = table_[entry + 1];
    const double first = kStep * slope, step = next.value - value;
    const double square2 = 3.0 * step - 2.0 * first - kStep * next.slope;
    const double cube = first + kStep * next.slope - 2.0 * step;
    return {value + t * (first + t * (square2 + t * cube)),
            (first + t * (2.0 * square2 + 3.0 * t * cube)) / kStep};
  }

  Window window_;
  std::vector<Entry> table_;
};

/// The parameters of a kernel by which densities are differentiated: the logarithm of the energy,
/// the two frequencies, the logarithms of both stretches, the shear.
inline constexpr std::size_t kKernelParameters = 6;
using KernelSlopes = std::array<double, kKernelParameters>;

/// The power of a ring at frequencies of this length [cycles / tile]: its integral over all
/// frequencies is the energy.
[[nodiscard]] double ringDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel,
                                   double frequency);

/// The power at the frequency (u, v) [cycles / tile] where the noise is sampled once in each of
/// `texels` x `texels` texels of a tile: with the power of the frequencies that are then the same.
/// `slopes`, unless null: its derivatives; not of rings.
[[nodiscard]] double sampledDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel,
                                      const std::array<double, 2>& texels, double u, double v,
                                      KernelSlopes* slopes = nullptr);

} // namespace lichen::multiple_kernels
