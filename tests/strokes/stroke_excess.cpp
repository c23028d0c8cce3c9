// SPDX-License-Identifier: MIT
// How much more an image consists of strokes than images of its spectrum and histogram with random
// phases: the coherence of the structure tensor [BG87] in octave bands.
//
// Image (height, width) -> the excess of its coherence, and what chance makes of it.
#include "stroke_excess.h"

#include <lichen/fft.h>
#include <lichen/spectrum.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace lichen::test {
namespace {

using Plane = std::vector<float>;

/// Middles of the bands [pixels]: octaves down from the half diagonal of the frequencies that
/// pixels hold, 1/2 + 1/2 cycles per pixel.
constexpr std::array<double, 3> kWavelengths{2.83, 5.66, 11.3};
using Bands = std::array<double, kWavelengths.size()>;

/// Bands with less of the variance are left out: rounding and aliasing make them.
constexpr double kLeastShare = 0.03;

/// A share of the mean energy, added to the energy of each pixel: where nothing varies, nothing is
/// coherent.
constexpr double kLeastEnergy = 1e-3;

/// The quantiles of a normal distribution at (k + 1/2) / count, by Newton's method from the one
/// before, from the middle outwards.
Plane normalQuantiles(std::size_t count) {
  constexpr int kSteps = 4;
  Plane quantiles(count, 0.0f);
  double x = 0.0;
  for (std::size_t k = count / 2; k < count; ++k) {
    const double above = (double(count - k) - 0.5) / double(count);
    for (int step = 0; step < kSteps; ++step)
      x += (0.5 * std::erfc(x / std::numbers::sqrt2) - above) * std::sqrt(2.0 * std::numbers::pi) *
           std::exp(0.5 * x * x);
    quantiles[k] = float(x);
    quantiles[count - 1 - k] = -float(x);
  }
  return quantiles;
}

/// The values replaced by the quantiles of their ranks.
Plane ranked(const Plane& plane, const Plane& quantiles) {
  std::vector<std::uint32_t> order(plane.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return plane[a] < plane[b] || (plane[a] == plane[b] && a < b);
  });
  Plane result(plane.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    result[order[rank]] = quantiles[rank];
  return result;
}

/// The plane of a spectrum times factor(u, v) of each frequency [cycles per pixel].
template <class Factor>
Plane filtered(HalfSpectrum spectrum, const Factor& factor) {
  for (int v = 0; v < spectrum.height; ++v)
    for (int u = 0; u < spectrum.columns(); ++u)
      spectrum.at(u, v) *=
          factor(double(u) / spectrum.width, double(spectrum.signedRow(v)) / spectrum.height);
  return inverseFft(spectrum);
}

/// cos(pi/2 |log2(f / f0)|) within an octave: the squares of all bands sum to 1.
double bandFactor(double u, double v, double wavelength) {
  const double frequency = std::hypot(u, v);
  if (frequency == 0.0)
    return 0.0;
  const double octaves = std::abs(std::log2(frequency * wavelength));
  return std::cos(0.5 * std::numbers::pi * std::min(1.0, octaves));
}

/// The share of a band in the variance.
Bands sharesOf(const HalfSpectrum& spectrum) {
  Bands shares{};
  double whole = 0.0;
  for (int v = 0; v < spectrum.height; ++v)
    for (int u = 0; u < spectrum.columns(); ++u) {
      if (u == 0 && v == 0)
        continue;
      const double power = spectrum.multiplicity(u) * double(std::norm(spectrum.at(u, v)));
      whole += power;
      for (std::size_t k = 0; k < shares.size(); ++k)
        shares[k] += power * std::pow(bandFactor(double(u) / spectrum.width,
                                                 double(spectrum.signedRow(v)) / spectrum.height,
                                                 kWavelengths[k]),
                                      2.0);
    }
  for (double& share : shares)
    share /= whole;
  return shares;
}

/// The mean coherence of a band: with z = d/dx + i d/dy of the band and a Gaussian G of one
/// wavelength, |G * z^2| over G * |z|^2. 1 where all gradients around are parallel.
double coherenceOf(const HalfSpectrum& spectrum, double wavelength) {
  const auto derivative = [&](bool alongX) {
    return filtered(spectrum, [&](double u, double v) {
      return std::complex<float>(0.0f, float((alongX ? u : v) * bandFactor(u, v, wavelength)));
    });
  };
  const Plane x = derivative(true), y = derivative(false);
  const auto averaged = [&](const auto& product) {
    Plane plane(x.size());
    for (std::size_t i = 0; i < plane.size(); ++i)
      plane[i] = product(x[i], y[i]);
    return filtered(forwardFft(plane, spectrum.width, spectrum.height), [&](double u, double v) {
      const double phase = std::numbers::pi * wavelength;
      return float(std::exp(-2.0 * phase * phase * (u * u + v * v)));
    });
  };
  const Plane real = averaged([](float a, float b) { return a * a - b * b; });
  const Plane imaginary = averaged([](float a, float b) { return 2.0f * a * b; });
  const Plane energy = averaged([](float a, float b) { return a * a + b * b; });
  const double mean = std::accumulate(energy.begin(), energy.end(), 0.0) / double(energy.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < energy.size(); ++i)
    sum += std::hypot(double(real[i]), double(imaginary[i])) /
           (std::max(0.0, double(energy[i])) + kLeastEnergy * mean);
  return sum / double(energy.size());
}

/// The excess of each image over the mean of all but the first, averaged over the bands by their
/// shares.
std::vector<double> excesses(const std::vector<Bands>& coherences, const Bands& shares) {
  std::vector<double> result(coherences.size(), 0.0);
  double whole = 0.0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (!(shares[k] > kLeastShare))
      continue;
    whole += shares[k];
    double mean = 0.0;
    for (std::size_t i = 1; i < coherences.size(); ++i)
      mean += coherences[i][k] / double(coherences.size() - 1);
    for (std::size_t i = 0; i < coherences.size(); ++i)
      result[i] += shares[k] * (coherences[i][k] / mean - 1.0);
  }
  for (double& value : result)
    value = whole > 0.0 ? value / whole : 0.0;
  return result;
}

} // namespace

StrokeExcess strokeExcess(const SrgbImage& result, int trials) {
  const int width = result.width, height = result.height;
  const Plane luminance = luminancePlane(result);
  const auto [least, most] = std::minmax_element(luminance.begin(), luminance.end());
  if (*least == *most)
    return {};
  const Plane quantiles = normalQuantiles(luminance.size());
  const HalfSpectrum spectrum =
      forwardFft(ranked(periodicComponent(luminance, width, height), quantiles), width, height);
  std::vector<Bands> coherences(std::size_t(trials) + 1); // of the image, then of its surrogates
  tbb::parallel_for(0, trials + 1, [&](int trial) {
    const HalfSpectrum own =
        trial == 0
            ? spectrum
            : forwardFft(ranked(phaseRandomizedPlane(spectrum, std::uint32_t(trial)), quantiles),
                         width, height);
    for (std::size_t k = 0; k < kWavelengths.size(); ++k)
      coherences[std::size_t(trial)][k] = coherenceOf(own, kWavelengths[k]);
  });
  const std::vector<double> all = excesses(coherences, sharesOf(spectrum));
  const double squares = std::inner_product(all.begin() + 1, all.end(), all.begin() + 1, 0.0);
  // That of one image about the mean of `trials` others.
  return {all.front(), std::sqrt(squares / (trials - 1.0) * (1.0 + 1.0 / trials))};
}

} // namespace lichen::test
