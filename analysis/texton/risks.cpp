// SPDX-License-Identifier: MIT
// One map -> the risks of a Gaussian texture of it. Thresholds: docs/decisions/007-verdicts.md.
//
// At any support, a texton's noise has Gaussian values and random phases, so it reproduces neither
// the exemplar's histogram nor its outlines. It also misses variation slower than the support.
#include "exemplar/color_space.h"
#include "exemplar/value_encoding.h"
#include "gaussian/normality.h"
#include "progress_part.h"
#include "suitability/risk_of.h"

#include <lichen/spectrum.h>
#include <lichen/suitability.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

using namespace suitability;

constexpr Calibration kTextonHistogram{0.17, 0.21};
constexpr Calibration kTextonOutlines{0.4, 1.3};
constexpr Calibration kTextonSlow{0.25, 0.5};

/// Tiling keeps the histogram, slow variation and most outlines.
const BakeSetting kTiling{"method", "tiling"};

constexpr int kOctaves = 4; // from a half wave of 2 pixels: details that the eye takes for outlines
constexpr int kOrientations = 4;

// Share of the progress, by processor time.
constexpr double kHistogramOfProgress = 0.2;

/// Returns the spectrum of one channel as a periodic plane without its mean.
HalfSpectrum channelSpectrum(const MapExemplar& map, std::size_t channel) {
  const std::size_t stride = map.channels.size();
  std::vector<float> plane(map.values.size() / stride);
  for (std::size_t i = 0; i < plane.size(); ++i)
    plane[i] = map.values[i * stride + channel];
  HalfSpectrum spectrum =
      forwardFft(periodicComponent(plane, map.width, map.height), map.width, map.height);
  spectrum.values[0] = 0.0f;
  return spectrum;
}

/// Returns the distance of a frequency from 0, in cycles per texel of a plane of width x height
/// texels.
double radius(const HalfSpectrum& spectrum, int u, int v, int width, int height) {
  return std::hypot(double(u) / width, double(spectrum.signedRow(v)) / height);
}

/// Texels per tile, and texels per side of the texton's support.
struct Texels {
  int width = 0;
  int height = 0;
  int support = 0;
};

/// Returns the plane's waves within one octave and 45 degrees of `frequency` [cycles / texel] and
/// `orientation` [radians], sampled on as many points as they need.
std::vector<float> oriented(const HalfSpectrum& spectrum, double frequency, double orientation) {
  const auto samples = [&](int side) { return std::min(side, int(4.0 * frequency * side) + 2); };
  HalfSpectrum band{samples(spectrum.width), samples(spectrum.height), {}};
  band.values.resize(std::size_t(band.columns()) * std::size_t(band.height));
  for (int v = 0; v < band.height; ++v)
    for (int u = 0; u < band.columns(); ++u) {
      const int signedV = band.signedRow(v);
      const int row = signedV >= 0 ? signedV : signedV + spectrum.height;
      const double octaves = std::log2(
          std::max(radius(spectrum, u, row, spectrum.width, spectrum.height), 1e-9) / frequency);
      const double angle =
          std::atan2(double(signedV) / spectrum.height, double(u) / spectrum.width) - orientation;
      const double window = std::cos(0.5 * std::numbers::pi * octaves) * std::cos(2.0 * angle);
      if (std::abs(octaves) < 1.0 && window > 0.0)
        band.at(u, v) = spectrum.at(u, row) * float(window);
    }
  return inverseFft(band);
}

/// Returns the fourth moment over the squared second, minus 3; 0 for Gaussian values and for zeros.
double excessKurtosis(const std::vector<float>& plane) {
  double second = 0.0, fourth = 0.0;
  for (const float value : plane) {
    const double square = double(value) * double(value);
    second += square;
    fourth += square * square;
  }
  return second > 0.0 ? double(plane.size()) * fourth / (second * second) - 3.0 : 0.0;
}

/// Returns the mean excess kurtosis over the orientations. A crack or an edge stands out among
/// waves of its own orientation, but not among all of them together.
double outlinesAt(const HalfSpectrum& spectrum, double frequency) {
  double sum = 0.0;
  for (int k = 0; k < kOrientations; ++k)
    sum += excessKurtosis(oriented(spectrum, frequency, std::numbers::pi * k / kOrientations));
  return sum / kOrientations;
}

constexpr std::size_t kSupports = 5; // the support, twice as large, and so on

struct Waves {
  double outlines = 0.0; ///< mean of outlinesAt() over the finest octaves
  /// Share of the variance in waves longer than 2^k supports.
  std::array<double, kSupports> slow{};
};

/// Returns both measures over the channels, weighted by variance.
Waves wavesOf(const MapExemplar& map, const Texels& texels, ProgressPart progress) {
  Waves sum;
  double variance = 0.0;
  const std::size_t channels = map.channels.size();
  for (std::size_t c = 0; c < channels; ++c) {
    const HalfSpectrum spectrum = channelSpectrum(map, c);
    double power = 0.0;
    for (int v = 0; v < spectrum.height; ++v)
      for (int u = 0; u < spectrum.columns(); ++u) {
        const double here = spectrum.multiplicity(u) * double(std::norm(spectrum.at(u, v)));
        power += here;
        // waves per support
        const double supports =
            radius(spectrum, u, v, texels.width, texels.height) * texels.support;
        for (std::size_t k = 0; k < kSupports && std::ldexp(supports, int(k)) < 1.0; ++k)
          sum.slow[k] += here;
      }
    double kurtosis = 0.0;
    int octaves = 0;
    constexpr int kFewestWaves = 8; // along the shorter side, for a fourth moment
    for (int k = 0; k < kOctaves; ++k) {
      const double frequency = std::exp2(-2 - k);
      if (frequency * std::min(map.width, map.height) < kFewestWaves)
        break;
      kurtosis += outlinesAt(spectrum, frequency);
      ++octaves;
    }
    sum.outlines += octaves > 0 ? power * kurtosis / octaves : 0.0;
    variance += power;
    progress.reach(double(c + 1) / double(channels));
  }
  sum.outlines = variance > 0.0 ? std::max(0.0, sum.outlines / variance) : 0.0;
  for (double& slow : sum.slow)
    slow = variance > 0.0 ? slow / variance : 0.0;
  return sum;
}

/// The root of the mean variance of the channels.
double deviationOf(const MapExemplar& map) {
  const auto channels = int(map.channels.size());
  return std::sqrt(exemplar::momentsOf(map.values, channels).covariance.trace() / channels);
}

std::string oneDecimal(double value) {
  const long tenths = std::lround(10.0 * value);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

/// Returns the settings that help against slow variation. The first is the smallest support that
/// holds it, if one does.
std::vector<BakeSetting> settingsForSlow(const Texels& texels, const Waves& waves) {
  std::vector<BakeSetting> settings;
  for (std::size_t k = 1; k < kSupports; ++k) {
    const int larger = texels.support << k;
    if (larger > std::min({texels.width, texels.height, kMaxTextonSide}))
      break;
    if (waves.slow[k] < kTextonSlow.mild) {
      settings.push_back({"support", std::to_string(larger)});
      break;
    }
  }
  settings.push_back(kTiling);
  return settings;
}

std::vector<Risk> risksOf(const MapExemplar& map, const Texels& texels, ProgressPart progress) {
  const double deviation = deviationOf(map);
  // Rounding to the steps of the file does not count as a histogram.
  const bool varies = deviation > 0.5 * map.quantum;
  const double histogram = varies ? gaussian::distanceToGaussian(map) / deviation : 0.0;
  progress.reach(kHistogramOfProgress);
  const Waves waves =
      varies ? wavesOf(map, texels, progress.part(kHistogramOfProgress, 1.0)) : Waves{};
  return {riskOf("histogram", scoreOf(histogram, kTextonHistogram),
                 "the histogram differs from a Gaussian one by " + percent(histogram) +
                     " of the deviation",
                 "so colours that the exemplar does not have will appear", {{kTiling}, ""}),
          riskOf("outlines", scoreOf(waves.outlines, kTextonOutlines),
                 "fine detail has a kurtosis of " + oneDecimal(3.0 + waves.outlines) +
                     " (Gaussian noise has 3)",
                 "so outlines will be lost", {{kTiling}, ""}),
          riskOf("low-frequency", scoreOf(waves.slow[0], kTextonSlow),
                 percent(waves.slow[0]) + " of the variation is slower than the texton's " +
                     std::to_string(texels.support) + " texels",
                 "and will be lost", {settingsForSlow(texels, waves), ""})};
}

} // namespace

Result<std::vector<Risk>> assessTextonSuitability(const MapExemplar& map, int support,
                                                  const Progress& progress, int widthTexels,
                                                  int heightTexels) {
  const Texels texels{widthTexels > 0 ? widthTexels : map.width,
                      heightTexels > 0 ? heightTexels : map.height, support};
  return assessed(map,
                  [&] { return risksOf(exemplar::asStored(map), texels, ProgressPart(progress)); });
}

} // namespace lichen
