// SPDX-License-Identifier: MIT
// Windows -> their transforms as tables -> the power of a kernel at a frequency.
//
// Phases are independent at each impact, so the powers of the window around f and around -f add up:
// [MKN12] eq. 3.
#include "kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::multiple_kernels {
namespace {

using std::numbers::pi;

/// The transform of (1 - r^2)^order over the unit disk at the frequency z.
double diskTransform(int order, double z) {
  // Sonine's first integral.
  const double factor = std::tgamma(order + 1.0) / std::pow(pi, order);
  if (z < 1e-3) // the integral itself
    return pi / (order + 1.0);
  return factor * std::cyl_bessel_j(order + 1.0, 2.0 * pi * z) / std::pow(z, order + 1.0);
}

/// The integral of a power of one factor of a window on the square times `wave` over -1 to 1.
template <class Wave>
double axisIntegral(Window window, int power, const Wave& wave) {
  constexpr int kSteps = 512;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double p = (k + 0.5) / kSteps;
    sum += std::pow(windowAt(window, p, 0.0), power) * wave(p);
  }
  return 2.0 * sum / kSteps;
}

} // namespace

WindowSpectrum::WindowSpectrum(Window window) : window_(window), table_(kEntries + 1) {
  const bool isDisk = window == Window::gabor;
  const auto one = [](double) { return 1.0; };
  const double energy = isDisk ? diskTransform(6, 0.0) : axisIntegral(window, 2, one);
  for (std::size_t k = 0; k <= kEntries; ++k) {
    const double z = std::max(std::sqrt(double(k) * kStep), 1e-6);
    const double turn = 2.0 * pi * z;
    auto& [value, slope] = table_[k];
    if (isDisk) {
      value = diskTransform(3, z);
      slope = -0.25 * pi * pi * diskTransform(4, z); // of Sonine's integral by the square of z
    } else {
      value = axisIntegral(window, 1, [&](double p) { return std::cos(turn * p); });
      slope = axisIntegral(window, 1, [&](double p) { return -pi * p * std::sin(turn * p) / z; });
    }
    value /= std::sqrt(energy);
    slope /= std::sqrt(energy);
  }
}

namespace {

/// The power of one kernel, and its derivatives, summed over frequencies.
class DensitySum {
public:
  DensitySum(const WindowSpectrum& spectrum, const Kernel& kernel)
      : spectrum_(spectrum), kernel_(kernel) {}

  /// Adds the power of the wave (`side` 1) or of its mirror (-1), unless it is beyond `reach`.
  void add(double u, double v, double side, double reach) {
    const double dv = v - side * kernel_.frequency[1], y = kernel_.stretch[1] * dv;
    const double du = u - side * kernel_.frequency[0];
    const double x = kernel_.stretch[0] * du + kernel_.shear * dv;
    if (x * x + y * y > reach * reach)
      return;
    std::array<double, 2> slopes{};
    const double value = spectrum_.at(x, y, slopes);
    const double byX = value * slopes[0], byY = value * slopes[1];
    power_ += value * value;
    byFrequency_[0] -= side * byX;
    byFrequency_[1] -= side * byY;
    byStretch_[0] += byX * du;
    byStretch_[1] += byY * dv;
    byShear_ += byX * dv;
  }

  /// The power, and in `slopes`, unless null, its derivatives.
  double result(KernelSlopes* slopes) const {
    const auto [across, down] = kernel_.stretch;
    const double scale = 0.5 * kernel_.energy * across * down, power = scale * power_;
    if (slopes != nullptr)
      *slopes = {power,
                 2.0 * scale * across * byFrequency_[0],
                 2.0 * scale * (kernel_.shear * byFrequency_[0] + down * byFrequency_[1]),
                 power + 2.0 * scale * across * byStretch_[0],
                 power + 2.0 * scale * down * byStretch_[1],
                 2.0 * scale * byShear_};
    return power;
  }

private:
  const WindowSpectrum& spectrum_;
  const Kernel kernel_; // a copy, which no sum can change
  double power_ = 0.0;
  std::array<double, 2> byFrequency_{}, byStretch_{};
  double byShear_ = 0.0;
};

} // namespace

double ringDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel, double frequency) {
  // As many directions as their steps along the ring stay below the width of the spectrum.
  constexpr double kStepsPerWidth = 12.0;
  const double radius = kernel.frequency[0], stretch = kernel.stretch[0];
  const int directions =
      std::clamp(int(kStepsPerWidth * radius * stretch), 16, 2048); // half a turn
  // From the direction of the frequency to both sides alike, to where the table ends.
  const double step = pi / directions, cosine = std::cos(step), sine = std::sin(step);
  double across = std::cos(0.5 * step), down = std::sin(0.5 * step), sum = 0.0;
  for (int k = 0; k < directions; ++k) {
    const double x = stretch * (frequency - radius * across), y = stretch * radius * down;
    if (x * x + y * y > WindowSpectrum::kFarthest * WindowSpectrum::kFarthest)
      break;
    std::array<double, 2> slopes{};
    const double value = spectrum.at(x, y, slopes);
    sum += value * value;
    const double turned = across * cosine - down * sine;
    down = down * cosine + across * sine;
    across = turned;
  }
  return kernel.energy * stretch * stretch * sum / directions;
}

double sampledDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel,
                        const std::array<double, 2>& texels, double u, double v,
                        KernelSlopes* slopes) {
  const double reach = spectrum.reach();
  // The nearest aliases: kernels are wider than half a texel, so those beyond are weak.
  if (kernel.isRing) {
    double density = 0.0;
    for (const double atV : {v - texels[1], v, v + texels[1]})
      for (const double atU : {u - texels[0], u, u + texels[0]}) {
        const double length = std::hypot(atU, atV);
        if (kernel.stretch[0] * (length - kernel.frequency[0]) < reach)
          density += ringDensityAt(spectrum, kernel, length);
      }
    return density;
  }
  DensitySum sum(spectrum, kernel);
  for (const double side : {1.0, -1.0})
    for (const double atV : {v - texels[1], v, v + texels[1]}) {
      if (kernel.stretch[1] * std::abs(atV - side * kernel.frequency[1]) > reach)
        continue;
      for (const double atU : {u - texels[0], u, u + texels[0]})
        sum.add(atU, atV, side, reach);
    }
  return sum.result(slopes);
}

// The windows of kernels, and what is known of kernels without their spectra.
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
