// SPDX-License-Identifier: MIT
// A kernel of multiple-kernels noise: a window times a wave, thrown at random points with random
// phases. [MKN12] section 3.
#pragma once

#include <lichen/multiple_kernels_map.h>

#include <Eigen/Dense>

#include <array>

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

/// The kernel of a row of a map's image. Its energy is the energy in the map's Gaussian values.
[[nodiscard]] Kernel kernelOf(const KernelRow& row, bool isRing);

/// w at (p, q).
[[nodiscard]] double windowAt(Window window, double p, double q);

/// The mean square frequency of a window along one axis [(cycles per unit of p)^2]: by quadrature,
/// integral (dw/dp)^2 / (4 pi^2 integral w^2).
[[nodiscard]] double windowSpread(Window window);

/// The integral of the square of a kernel, on average over its signs [tiles^2]: the integral of its
/// window.
[[nodiscard]] double squareIntegral(Window window, const Kernel& kernel);

} // namespace lichen::multiple_kernels
