// SPDX-License-Identifier: MIT
// Windows -> their transforms as tables -> the power of a kernel at a frequency.
//
// Phases are independent at each impact, so the powers of the window around f and around -f add up:
// [MKN12] eq. 3.
#include "kernel_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::multiple_kernels {
namespace {

using std::numbers::pi;

/// Tables reach this far [cycles per unit], where less than 1e-4 of any window's energy is left but
/// for the sinc's.
constexpr double kFarthest = 12.0;
constexpr std::size_t kEntries = 1u << 14; // evenly in the square root of the square

double entryFrequency(std::size_t entry) { return kFarthest * double(entry) / double(kEntries); }

/// The transform of (1 - r^2)^order over the unit disk at the frequency z.
double diskTransform(int order, double z) {
  // Sonine's first integral.
  const double factor = std::tgamma(order + 1.0) / std::pow(pi, order);
  if (z < 1e-3) // the integral itself
    return pi / (order + 1.0);
  return factor * std::cyl_bessel_j(order + 1.0, 2.0 * pi * z) / std::pow(z, order + 1.0);
}

/// The transform of a power of one factor of a window on the square.
double axisTransform(Window window, int power, double z) {
  constexpr int kSteps = 512;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double p = (k + 0.5) / kSteps;
    sum += std::pow(windowAt(window, p, 0.0), power) * std::cos(2.0 * pi * z * p);
  }
  return 2.0 * sum / kSteps;
}

} // namespace

double WindowSpectrum::Profile::at(double square, double& slope) const {
  const double place = std::sqrt(std::max(square, 0.0)) / kFarthest * double(values.size() - 1);
  const auto entry = std::size_t(place);
  if (entry + 1 >= values.size()) {
    slope = 0.0;
    return 0.0;
  }
  const double step = values[entry + 1] - values[entry];
  const double low = entryFrequency(entry), high = entryFrequency(entry + 1);
  slope = step / (high * high - low * low);
  return values[entry] + (place - double(entry)) * step;
}

WindowSpectrum::WindowSpectrum(Window window) : window_(window) {
  spectrum_.values.resize(kEntries + 1);
  const bool isDisk = window == Window::gabor;
  const double energy = isDisk ? diskTransform(6, 0.0) : axisTransform(window, 2, 0.0);
  for (std::size_t k = 0; k <= kEntries; ++k) {
    const double z = entryFrequency(k);
    spectrum_.values[k] =
        (isDisk ? diskTransform(3, z) : axisTransform(window, 1, z)) / std::sqrt(energy);
  }
}

double WindowSpectrum::valueAt(const Profile& profile, double x, double y,
                               std::array<double, 2>& slopes) const {
  if (window_ == Window::gabor) {
    const double value = profile.at(x * x + y * y, slopes[0]);
    slopes = {2.0 * x * slopes[0], 2.0 * y * slopes[0]};
    return value;
  }
  std::array<double, 2> own{};
  const double across = profile.at(x * x, own[0]), down = profile.at(y * y, own[1]);
  slopes = {2.0 * x * own[0] * down, 2.0 * y * across * own[1]};
  return across * down;
}

double densityAt(const WindowSpectrum& spectrum, const Kernel& kernel, double u, double v,
                 KernelSlopes* slopes) {
  const auto [across, down] = kernel.stretch;
  const double scale = 0.5 * kernel.energy * across * down;
  double density = 0.0;
  std::array<double, 5> derivatives{}; // by frequencies, logarithms of stretches, shear
  for (const double side : {1.0, -1.0}) {
    const double du = u - side * kernel.frequency[0], dv = v - side * kernel.frequency[1];
    const double x = across * du + kernel.shear * dv, y = down * dv;
    std::array<double, 2> own{};
    const double value = spectrum.at(x, y, own);
    const double power = scale * value * value;
    density += power;
    if (slopes == nullptr)
      continue;
    const double byX = 2.0 * scale * value * own[0], byY = 2.0 * scale * value * own[1];
    derivatives[0] -= side * byX * across;
    derivatives[1] -= side * (byX * kernel.shear + byY * down);
    derivatives[2] += power + byX * across * du;
    derivatives[3] += power + byY * y;
    derivatives[4] += byX * dv;
  }
  if (slopes != nullptr) {
    (*slopes)[0] = density;
    std::copy(derivatives.begin(), derivatives.end(), slopes->begin() + 1);
  }
  return density;
}

double ringDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel, double frequency) {
  // As many directions as their steps along the ring stay below the width of the spectrum.
  constexpr double kStepsPerWidth = 12.0;
  const double radius = kernel.frequency[0], stretch = kernel.stretch[0];
  const int directions =
      std::clamp(int(kStepsPerWidth * radius * stretch), 16, 2048); // half a turn
  // From the direction of the frequency to both sides alike, to where the table ends.
  double sum = 0.0;
  for (int k = 0; k < directions; ++k) {
    const double angle = pi * (k + 0.5) / directions;
    const double x = stretch * (frequency - radius * std::cos(angle)),
                 y = stretch * radius * std::sin(angle);
    if (x * x + y * y > kFarthest * kFarthest)
      break;
    std::array<double, 2> slopes{};
    const double value = spectrum.at(x, y, slopes);
    sum += value * value;
  }
  return kernel.energy * stretch * stretch * sum / directions;
}

double sampledDensityAt(const WindowSpectrum& spectrum, const Kernel& kernel,
                        const std::array<double, 2>& texels, double u, double v,
                        KernelSlopes* slopes) {
  const auto [fx, fy] = kernel.frequency;
  const auto isNear = [&](double du, double dv) {
    const double x = kernel.stretch[0] * du + kernel.shear * dv, y = kernel.stretch[1] * dv;
    return x * x + y * y < spectrum.reach() * spectrum.reach();
  };
  const auto isInReach = [&](double atU, double atV) {
    return kernel.isRing ? isNear(std::hypot(atU, atV) - fx, 0.0)
                         : isNear(atU - fx, atV - fy) || isNear(atU + fx, atV + fy);
  };
  const auto isRowInReach = [&](double atV) {
    const double least = std::min(std::abs(atV - fy), std::abs(atV + fy));
    return kernel.isRing || kernel.stretch[1] * least < spectrum.reach();
  };
  double density = 0.0;
  if (slopes != nullptr)
    *slopes = {};
  // The nearest aliases: kernels are wider than half a texel, so those beyond are weak.
  for (const double atV : {v - texels[1], v, v + texels[1]}) {
    if (!isRowInReach(atV))
      continue;
    for (const double atU : {u - texels[0], u, u + texels[0]}) {
      if (!isInReach(atU, atV))
        continue;
      KernelSlopes own{};
      density += kernel.isRing
                     ? ringDensityAt(spectrum, kernel, std::hypot(atU, atV))
                     : densityAt(spectrum, kernel, atU, atV, slopes == nullptr ? nullptr : &own);
      if (slopes != nullptr)
        for (std::size_t p = 0; p < own.size(); ++p)
          (*slopes)[p] += own[p];
    }
  }
  return density;
}

} // namespace lichen::multiple_kernels
