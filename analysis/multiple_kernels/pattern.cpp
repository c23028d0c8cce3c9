// SPDX-License-Identifier: MIT
// A picture or a spline -> the cosines of its Fourier series.
#include <lichen/fft.h>
#include <lichen/pattern.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <map>
#include <numbers>
#include <utility>

namespace lichen {

std::vector<PatternWave> strongestWaves(std::span<const PatternWave> waves, int cosines) {
  std::map<std::pair<int, int>, std::complex<double>> sums;
  for (const PatternWave& wave : waves) {
    // The one of two mirrors with u above 0, or with v.
    const bool isMirror = wave.u < 0 || (wave.u == 0 && wave.v < 0);
    const double angle = (isMirror ? -2.0 : 2.0) * std::numbers::pi * wave.phase;
    sums[isMirror ? std::pair(-wave.u, -wave.v) : std::pair(wave.u, wave.v)] +=
        wave.amplitude * std::complex<double>(std::cos(angle), std::sin(angle));
  }
  std::vector<PatternWave> result;
  for (const auto& [frequency, sum] : sums)
    result.push_back({frequency.first, frequency.second, std::abs(sum),
                      std::arg(sum) / (2.0 * std::numbers::pi)});
  std::stable_sort(result.begin(), result.end(), [](const PatternWave& a, const PatternWave& b) {
    return a.amplitude > b.amplitude;
  });
  result.resize(std::min(result.size(), std::size_t(cosines)));
  return result;
}

std::vector<PatternWave> patternOf(const SrgbImage& picture, int repeats, int cosines) {
  const HalfSpectrum spectrum = forwardFft(luminancePlane(picture), picture.width, picture.height);
  const double perPixel = 2.0 / (double(picture.width) * picture.height);
  std::vector<PatternWave> waves;
  for (int row = 0; row < spectrum.height; ++row) {
    const int v = spectrum.signedRow(row);
    for (int u = 0; 2 * u < spectrum.width; ++u) {
      const bool isMirror = u == 0 && v <= 0;
      if (isMirror || 2 * std::abs(v) >= spectrum.height)
        continue;
      const std::complex<double> value(spectrum.at(u, row));
      // Texels lie half a texel from the corner.
      const double corner = 0.5 * (double(u) / picture.width + double(v) / picture.height);
      waves.push_back({repeats * u, repeats * v, perPixel * std::abs(value),
                       std::arg(value) / (2.0 * std::numbers::pi) - corner});
    }
  }
  return strongestWaves(waves, cosines);
}

std::vector<PatternWave> patternOfSpline(int u, int v, std::span<const double> points) {
  const auto count = double(points.size());
  std::vector<PatternWave> waves;
  for (int harmonic = 1; harmonic <= int(points.size()); ++harmonic) {
    std::complex<double> sum = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k)
      sum += points[k] * std::polar(1.0, -2.0 * std::numbers::pi * harmonic * double(k) / count);
    // The transform of the cubic B-spline between the points.
    const double x = std::numbers::pi * harmonic / count;
    const double amplitude = 2.0 / count * std::abs(sum) * std::pow(std::sin(x) / x, 4.0);
    constexpr double kLeast = 1e-9;
    if (amplitude > kLeast)
      waves.push_back(
          {harmonic * u, harmonic * v, amplitude, std::arg(sum) / (2.0 * std::numbers::pi)});
  }
  return waves;
}

} // namespace lichen
