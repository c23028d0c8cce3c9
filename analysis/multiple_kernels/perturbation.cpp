// SPDX-License-Identifier: MIT
// Transforms of Gaussian channels -> the cosines of a pattern, and scales that keep covariances.
#include "perturbation.h"

#include "transport/covariance.h"

#include <lichen/fft.h>
#include <lichen/multiple_kernels.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

namespace lichen::multiple_kernels {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using random_phase::MapSpectrum;

VectorXcd channelsAt(std::span<const MapSpectrum> maps, int u, int v) {
  Index channels = 0, row = 0;
  for (const MapSpectrum& map : maps)
    channels += Index(map.channels.size());
  VectorXcd values(channels);
  for (const MapSpectrum& map : maps)
    for (std::size_t c = 0; c < map.channels.size(); ++c)
      values[row++] = map.at(c, u, v);
  return values;
}

/// Takes a frequency and its mirror out of all maps.
void remove(std::vector<MapSpectrum>& maps, int u, int v) {
  if (u < 0)
    return remove(maps, -u, -v);
  for (MapSpectrum& map : maps) {
    const VectorXcd values = channelsAt({&map, 1}, u, v);
    map.covariance -= 2.0 * (values * values.adjoint()).real();
    for (HalfSpectrum& own : map.channels) {
      if (2 * u >= own.width || 2 * std::abs(v) >= own.height)
        continue;
      own.at(u, v < 0 ? v + own.height : v) = 0.0f;
      if (u == 0)
        own.at(0, v > 0 ? own.height - v : -v) = 0.0f;
    }
  }
}

/// The frequencies of the largest powers.
std::vector<PatternTerm> strongest(int cosines, std::vector<MapSpectrum>& maps) {
  const random_phase::PowerPlane plane = random_phase::powerPlane(maps);
  struct Place {
    double power = 0.0;
    int u = 0, v = 0;
  };
  std::vector<Place> places;
  for (int row = 0; row < plane.rows; ++row)
    for (int u = 0; u < plane.columns; ++u)
      if (const int v = row - plane.rows / 2; u > 0 || v > 0)
        places.push_back(
            {plane.values[std::size_t(row) * std::size_t(plane.columns) + std::size_t(u)], u, v});
  const auto count = std::min(places.size(), std::size_t(cosines));
  std::partial_sort(places.begin(), places.begin() + std::ptrdiff_t(count), places.end(),
                    [](const Place& a, const Place& b) {
                      return std::tuple(-a.power, a.u, a.v) < std::tuple(-b.power, b.u, b.v);
                    });
  places.resize(count);
  std::vector<PatternTerm> terms;
  for (const Place& place : places) {
    const VectorXcd values = channelsAt(maps, place.u, place.v);
    Eigen::MatrixX2d waves(values.size(), 2); // both mirrors
    waves << 2.0 * values.real(), -2.0 * values.imag();
    terms.push_back({place.u, place.v, std::move(waves)});
    remove(maps, place.u, place.v);
  }
  return terms;
}

/// The covariance of all channels of all maps.
MatrixXd covarianceOf(const std::vector<MapSpectrum>& maps) {
  const random_phase::PowerPlane plane = random_phase::powerPlane(maps);
  const Index channels = random_phase::firstChannels(maps).back();
  MatrixXd covariance = MatrixXd::Zero(channels, channels);
  for (int v = -(plane.rows / 2); v <= plane.rows / 2; ++v)
    for (int u = 0; u < plane.columns; ++u)
      if (u > 0 || v != 0) {
        covariance += (u == 0 ? 1.0 : 2.0) * random_phase::crossPower(maps, u, v).real();
      }
  random_phase::setMapCovariances(covariance, maps);
  return covariance;
}

/// How all channels follow the luminance of the first map that has one, or else the first map's
/// values: the covariance with it where it has the variance 1.
VectorXd luminanceAxis(const MatrixXd& covariance, const std::vector<MapSpectrum>& maps) {
  const std::vector<Index> first = random_phase::firstChannels(maps);
  VectorXd weights = VectorXd::Zero(first.back());
  std::size_t leading = 0;
  while (leading < maps.size() && maps[leading].luminance.empty())
    ++leading;
  if (leading == maps.size()) {
    leading = 0;
    while (leading + 1 < maps.size() && maps[leading].channels.empty())
      ++leading;
    weights.segment(first[leading], first[leading + 1] - first[leading]) =
        maps[leading].toStored.colwise().sum().transpose();
  } else {
    for (std::size_t c = 0; c < maps[leading].luminance.size(); ++c)
      weights[first[leading] + Index(c)] = maps[leading].luminance[c];
  }
  const double variance = weights.dot(covariance * weights);
  return covariance * weights / std::sqrt(std::max(variance, 1e-30));
}

/// A given pattern along that axis, with variance 1.
std::vector<PatternTerm> given(const Perturbation& perturbation, const VectorXd& axis,
                               std::vector<MapSpectrum>& maps) {
  const std::vector<PatternWave> waves = strongestWaves(perturbation.pattern, perturbation.cosines);
  double variance = 0.0;
  for (const PatternWave& wave : waves)
    variance += 0.5 * wave.amplitude * wave.amplitude;
  std::vector<PatternTerm> terms;
  for (const PatternWave& wave : waves) {
    const double amplitude = wave.amplitude / std::sqrt(variance);
    const double angle = 2.0 * std::numbers::pi * wave.phase;
    Eigen::MatrixX2d own(axis.size(), 2);
    own << amplitude * std::cos(angle) * axis, -amplitude * std::sin(angle) * axis;
    terms.push_back({wave.u, wave.v, std::move(own)});
    remove(maps, wave.u, wave.v);
  }
  return terms;
}

} // namespace

TakenPattern takePattern(const Perturbation& perturbation, std::vector<MapSpectrum>& maps) {
  TakenPattern taken;
  if (random_phase::firstChannels(maps).back() == 0) // nothing varies
    return taken;
  taken.whole = covarianceOf(maps);
  if (perturbation.pattern.empty()) {
    taken.terms = strongest(perturbation.cosines, maps);
  } else {
    taken.luminance = luminanceAxis(taken.whole, maps);
    taken.terms = given(perturbation, taken.luminance, maps);
  }
  return taken;
}

std::vector<PerturbedScale> perturbedScales(const TakenPattern& pattern, const MatrixXd& noise,
                                            const std::vector<Index>& firstChannels,
                                            double amount) {
  const bool isGiven = pattern.luminance.size() > 0;
  const double share = 1.0 / (1.0 + amount * amount);
  MatrixXd together = amount * amount * noise;
  for (const PatternTerm& term : pattern.terms)
    together += 0.5 * term.waves * term.waves.transpose();
  std::vector<PerturbedScale> scales;
  for (std::size_t m = 0; m + 1 < firstChannels.size(); ++m) {
    const Index first = firstChannels[m], count = firstChannels[m + 1] - first;
    const MatrixXd whole = pattern.whole.block(first, first, count, count);
    if (count == 0) {
      scales.emplace_back();
    } else if (isGiven) {
      const VectorXd own = pattern.luminance.segment(first, count);
      const MatrixXd rest = whole - share * own * own.transpose();
      scales.push_back(
          {std::sqrt(share) * MatrixXd::Identity(count, count),
           transport::covarianceMap<MatrixXd>(noise.block(first, first, count, count), rest)});
    } else {
      const MatrixXd scale =
          transport::covarianceMap<MatrixXd>(together.block(first, first, count, count), whole);
      scales.push_back({scale, amount * scale});
    }
  }
  return scales;
}

} // namespace lichen::multiple_kernels

// A picture or a spline -> the cosines of its Fourier series.

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
