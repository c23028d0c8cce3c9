// SPDX-License-Identifier: MIT
// Power spectrum of a plane (height, width / 2 + 1) -> contrast variation of its random blends.
// Source: [HN18] section 5.3 on stationarity; the header derives the closed form.
#include "spectral_measures.h"

#include "exemplar/low_pass.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace lichen::suitability {
double cloudiness(const HalfSpectrum& spectrum, std::optional<double> longestPeriod) {
  double sum = 0.0, squares = 0.0;
  for (int v = 0; v < spectrum.height; ++v)
    for (int u = 0; u < spectrum.columns(); ++u) {
      if (u == 0 && v == 0)
        continue;
      const double slow =
          !longestPeriod
              ? 0.0
              : exemplar::lowPassGain(*longestPeriod * u / spectrum.width,
                                      *longestPeriod * spectrum.signedRow(v) / spectrum.height);
      const double gain = 1.0 - slow;
      const double power = gain * gain * double(std::norm(spectrum.at(u, v)));
      sum += spectrum.multiplicity(u) * power;
      squares += spectrum.multiplicity(u) * power * power;
    }
  return sum > 0.0 ? 2.0 / 3.0 * std::sqrt(3.0 * squares) / sum : 0.0;
}

// Spectrum of a plane (height, width / 2 + 1) -> share of its variance in spectral lines.
namespace {

/// Neighbours on each side that enter the median. With a lattice line at every fourth frequency,
/// each spread over its four neighbours, the 9 x 9 frequencies around a line hold nine lines. Four
/// of them are cut at one side and four at two: 5 + 4 * 4 + 4 * 3 = 33 of 81 frequencies. This is
/// less than half, so the median is the power between the lines.
constexpr int kReach = 4;
constexpr int kNeighbours = (2 * kReach + 1) * (2 * kReach + 1);
constexpr float kLineOverMedian = 20.0f; // derived in the header
constexpr int kReachAlong = 8;           // frequencies on each side along the direction
/// Keeps the mean, whose power has no meaning here, out of the neighbours.
constexpr int kLowestCycles = kReach + 1;
/// Half of it is the highest frequency. Along each axis, the eight frequencies from kLowestCycles
/// to kReach below the highest have all their neighbours, and no neighbour is its own mirror image.
constexpr int kSmallestSide = 32;
static_assert(kSmallestSide / 2 - kReach - kLowestCycles + 1 == 8);

/// Power at the integer frequencies of the full plane, and of some beyond each border of the half
/// spectrum.
class PowerPlane {
public:
  explicit PowerPlane(const HalfSpectrum& spectrum)
      : width_(spectrum.width), height_(spectrum.height), columns_(spectrum.columns()) {
    power_.reserve(spectrum.values.size());
    for (const std::complex<float>& value : spectrum.values)
      power_.push_back(std::norm(value));
  }
  [[nodiscard]] bool contains(int u, int v) const {
    return 2 * std::abs(u) <= width_ && 2 * std::abs(v) <= height_;
  }
  [[nodiscard]] float at(int u, int v) const {
    v += v < 0 ? height_ : v >= height_ ? -height_ : 0;
    // A frequency outside the stored half is the mirror image of one inside.
    if (u < 0 || u >= columns_) {
      u = u < 0 ? -u : width_ - u;
      v = v == 0 ? 0 : height_ - v;
    }
    return power_[std::size_t(v) * std::size_t(columns_) + std::size_t(u)];
  }

private:
  int width_;
  int height_;
  int columns_;
  std::vector<float> power_;
};

/// Whether the power exceeds the given multiple of the median around it: whether most powers there
/// are smaller by that factor.
bool isLine(const PowerPlane& power, int u, int v) {
  const float most = power.at(u, v) / kLineOverMedian;
  int below = 0;
  for (int dv = -kReach; dv <= kReach; ++dv)
    for (int du = -kReach; du <= kReach; ++du)
      below += power.at(u + du, v + dv) < most ? 1 : 0;
  return 2 * below > kNeighbours;
}

/// Whether the power also stands out among the powers of its own direction, on both sides of it: it
/// exceeds three eighths of the frequencies on either side by the same factor. Streaks that are
/// longer than the image have all their power in one direction, where no frequency stands out from
/// the others; stripes have few frequencies of it.
bool isLineOfItsDirection(const PowerPlane& power, int u, int v) {
  const float most = power.at(u, v) / kLineOverMedian;
  const double radius = std::hypot(double(u), double(v));
  const auto quietSide = [&](double step) {
    int below = 0;
    for (int k = 1; k <= kReachAlong; ++k) {
      const double scale = (radius + step * k) / radius;
      const int across = int(std::lround(scale * u)), down = int(std::lround(scale * v));
      // The mean has no meaning, and there is nothing beyond the highest frequency.
      below +=
          scale * radius < 1.0 || !power.contains(across, down) || power.at(across, down) < most
              ? 1
              : 0;
    }
    return 8 * below >= 3 * kReachAlong;
  };
  return quietSide(-1.0) && quietSide(1.0);
}

} // namespace

double latticeShare(const HalfSpectrum& spectrum) {
  if (std::min(spectrum.width, spectrum.height) < kSmallestSide)
    return 0.0;
  const PowerPlane power(spectrum);
  std::vector<std::array<double, 2>> rows(std::size_t(spectrum.height)); // in lines, and in total
  tbb::parallel_for(0, spectrum.height, [&](int v) {
    const int signedV = spectrum.signedRow(v);
    auto& [lines, all] = rows[std::size_t(v)];
    for (int u = 0; u < spectrum.columns(); ++u) {
      if (u == 0 && v == 0)
        continue;
      const double weighted = spectrum.multiplicity(u) * double(power.at(u, v));
      all += weighted;
      if (u * u + signedV * signedV >= kLowestCycles * kLowestCycles && isLine(power, u, v) &&
          isLineOfItsDirection(power, u, signedV))
        lines += weighted;
    }
  });
  double lines = 0.0, all = 0.0;
  for (const auto& row : rows) {
    lines += row[0];
    all += row[1];
  }
  return all > 0.0 ? lines / all : 0.0;
}

// Spectrum of a plane (height, width / 2 + 1) -> phase coherence across scales.
//
// Bands are complex: they pass only the frequencies on the positive side of their orientation, so
// modulus and argument are the local amplitude and phase. They resemble the steerable pyramid of
// their source [PS00].
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
