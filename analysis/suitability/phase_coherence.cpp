// SPDX-License-Identifier: MIT
// Spectrum of a plane (height, width / 2 + 1) -> phase coherence across scales.
//
// Bands are complex: they pass only the frequencies on the positive side of their orientation, so
// modulus and argument are the local amplitude and phase. They resemble the steerable pyramid of
// their source [PS00].
#include "phase_coherence.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lichen::suitability {
namespace {

constexpr int kOrientations = 4;
constexpr double kFinestPeriod = 8.0; // pixels; shorter periods hold grain and JPEG artefacts
constexpr int kFewestPeriods = 8;     // of a coarse band along the shorter side

/// cos^3, the angular profile of [PS00] for four orientations, on the positive side only.
double angularGain(double cosine) { return cosine > 0.0 ? cosine * cosine * cosine : 0.0; }

/// A cosine of log2 of the frequency, one octave to each side of the centre.
double radialGain(double frequency, double centre) {
  const double octaves = std::log2(frequency / centre);
  return std::abs(octaves) < 1.0 ? std::cos(0.5 * std::numbers::pi * octaves) : 0.0;
}

/// A complex plane, as the pair of planes from two real transforms.
struct Band {
  std::vector<float> real;
  std::vector<float> imaginary;
};

/// The band at `frequency` cycles per pixel, sampled on width x height points. Only the spectrum's
/// lower frequencies are needed; they hold the whole band.
Band band(const HalfSpectrum& spectrum, double frequency, int orientation, int width, int height) {
  const double angle = std::numbers::pi * orientation / kOrientations;
  const double directionX = std::cos(angle), directionY = std::sin(angle);
  HalfSpectrum even{width, height, {}};
  even.values.resize(std::size_t(even.columns()) * std::size_t(height));
  HalfSpectrum odd = even;
  for (int v = 0; v < height; ++v) {
    const int signedV = even.signedRow(v);
    const double y = double(signedV) / spectrum.height;
    const int row = signedV >= 0 ? signedV : signedV + spectrum.height;
    for (int u = 0; u < even.columns(); ++u) {
      const double x = double(u) / spectrum.width;
      const double radius = std::hypot(x, y);
      const double radial = radius > 0.0 ? radialGain(radius, frequency) : 0.0;
      if (radial == 0.0)
        continue;
      const double cosine = (x * directionX + y * directionY) / radius;
      const std::complex<float> value = spectrum.at(u, row);
      // The gains of the frequency and of its mirror image give the real and imaginary parts.
      const double here = angularGain(cosine), mirrored = angularGain(-cosine);
      even.at(u, v) = value * float(0.5 * radial * (here + mirrored));
      odd.at(u, v) = value * std::complex<float>(0.0f, float(-0.5 * radial * (here - mirrored)));
    }
  }
  return {inverseFft(even), inverseFft(odd)};
}

/// A coherence and the energy that is its weight.
struct Coherence {
  double value = 0.0;
  double energy = 0.0;
};

Coherence coherence(const Band& fine, const Band& coarse) {
  std::complex<double> correlation = 0.0;
  double fineEnergy = 0.0, coarseEnergy = 0.0;
  for (std::size_t i = 0; i < fine.real.size(); ++i) {
    const std::complex<double> f(double(fine.real[i]), double(fine.imaginary[i]));
    const std::complex<double> c(double(coarse.real[i]), double(coarse.imaginary[i]));
    fineEnergy += std::norm(f);
    coarseEnergy += std::norm(c);
    if (const double modulus = std::abs(c); modulus > 0.0)
      correlation += f * std::conj(c * c / modulus);
  }
  const double norm = std::sqrt(fineEnergy * coarseEnergy);
  return {norm > 0.0 ? std::abs(correlation) / norm : 0.0, fineEnergy};
}

/// The number of samples along a side of `side` pixels for frequencies up to `highest` cycles per
/// pixel.
int samplesFor(int side, double highest) {
  // One more than twice the highest frequency, so that it stays below the Nyquist frequency.
  return std::min(side, int(2.0 * highest * side) + 2);
}

} // namespace

double phaseCoherence(const HalfSpectrum& spectrum) {
  const int shorter = std::min(spectrum.width, spectrum.height);
  int scales = 0;
  while (kFinestPeriod * std::exp2(scales + 1) * kFewestPeriods <= shorter)
    ++scales;
  std::vector<Coherence> parts(std::size_t(scales * kOrientations));
  tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t part) {
    const auto scale = int(part) / kOrientations;
    const auto orientation = int(part) % kOrientations;
    const double frequency = std::exp2(-scale) / kFinestPeriod;
    // Doubling the coarse phase doubles its frequencies, which moves them into the fine band.
    const int width = samplesFor(spectrum.width, 2.0 * frequency);
    const int height = samplesFor(spectrum.height, 2.0 * frequency);
    parts[part] = coherence(band(spectrum, frequency, orientation, width, height),
                            band(spectrum, 0.5 * frequency, orientation, width, height));
    // Bands have grids of different sizes, and transforms are divided by the size.
    parts[part].energy *= double(width) * double(height);
  });
  double sum = 0.0, energy = 0.0;
  for (const Coherence& part : parts) {
    sum += part.value * part.energy;
    energy += part.energy;
  }
  return energy > 0.0 ? sum / energy : 0.0;
}

} // namespace lichen::suitability
