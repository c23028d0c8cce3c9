// SPDX-License-Identifier: MIT
// The windows of kernels, and what is known of kernels without their spectra.
#include "kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::multiple_kernels {
namespace {

using std::numbers::pi;

constexpr double kSincZeros = 2.0; // of a sinc from its middle to its end

double sinc(double t) {
  const double turn = pi * kSincZeros * t;
  return std::abs(turn) < 1e-6 ? 1.0 : std::sin(turn) / turn;
}

/// Calls visit(p, q, weight) for the midpoints of a grid over the window's square.
template <class Visit>
void overSquare(const Visit& visit) {
  constexpr int kSide = 128;
  constexpr double kStep = 2.0 / kSide;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i)
      visit(-1.0 + (i + 0.5) * kStep, -1.0 + (j + 0.5) * kStep, kStep * kStep);
}

} // namespace

Eigen::Matrix2d Kernel::toWindow() const {
  Eigen::Matrix2d inverseTransposed;
  inverseTransposed << stretch[0], shear, 0.0, stretch[1];
  return inverseTransposed.inverse().transpose();
}

std::array<double, 2> Kernel::reach(Window window) const {
  if (window != Window::gabor)
    return stretch;
  return {stretch[0], std::hypot(shear, stretch[1])};
}

double Kernel::area(Window window) const {
  return (window == Window::gabor ? pi : 4.0) * stretch[0] * stretch[1];
}

Kernel kernelOf(const KernelRow& row, bool isRing) {
  Kernel kernel;
  for (const std::array<float, 4>& color : row.colors)
    for (const float factor : color)
      kernel.energy += double(factor) * double(factor);
  kernel.frequency = {double(row.frequency[0]), double(row.frequency[1])};
  const auto& q = row.toWindow;
  kernel.stretch = {1.0 / double(q[0]), 1.0 / double(q[3])};
  kernel.shear = -double(q[2]) * kernel.stretch[0] * kernel.stretch[1];
  kernel.isRing = isRing;
  return kernel;
}

double windowAt(Window window, double p, double q) {
  if (window == Window::gabor) {
    const double left = std::max(0.0, 1.0 - p * p - q * q);
    return left * left * left;
  }
  if (std::abs(p) >= 1.0 || std::abs(q) >= 1.0)
    return 0.0;
  const double product = sinc(p) * sinc(q);
  if (window == Window::sinc)
    return product;
  const double taper = (1.0 - p * p) * (1.0 - q * q);
  return product * taper * taper;
}

double windowSpread(Window window) {
  constexpr double kStep = 1e-4;
  double slopes = 0.0, squares = 0.0;
  overSquare([&](double p, double q, double weight) {
    const double slope =
        (windowAt(window, p + kStep, q) - windowAt(window, p - kStep, q)) / (2.0 * kStep);
    const double value = windowAt(window, p, q);
    slopes += weight * slope * slope;
    squares += weight * value * value;
  });
  return slopes / (4.0 * pi * pi * squares);
}

double squareIntegral(Window window, const Kernel& kernel) {
  double sum = 0.0;
  overSquare([&](double p, double q, double weight) {
    const double value = windowAt(window, p, q);
    sum += weight * value * value;
  });
  return sum * kernel.stretch[0] * kernel.stretch[1];
}

} // namespace lichen::multiple_kernels
