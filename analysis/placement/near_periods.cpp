// SPDX-License-Identifier: MIT
// Stored values -> autocorrelation -> shifts, drawn one after the other where the autocorrelation
// around all that are chosen is high.
//
// [LSD23] draws offsets by the autocovariance as a density. Here each also repeats those before it,
// and a field without periods is recognized. The constants were chosen on twelve exemplars, on
// which they were also judged. Source: docs/decisions/009-local-random-phase.md.
#include "near_periods.h"

#include "exemplar/planes.h"

#include <lichen/fft.h>
#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lichen::placement {
namespace {

/// Of a periodic image: 1 at (0, 0).
using Autocorrelation = exemplar::Plane;

/// Random numbers in [0, 1).
class Generator {
public:
  explicit Generator(std::uint32_t seed) : state_(seed) {}
  [[nodiscard]] double next() { return double(pcg(state_++)) * 0x1p-32; }

private:
  std::uint32_t state_;
};

/// The power of all channels of the largest maps, each over its map's.
HalfSpectrum powerOf(std::span<const MapExemplar> maps) {
  const MapExemplar& largest =
      *std::max_element(maps.begin(), maps.end(), [](const MapExemplar& a, const MapExemplar& b) {
        return std::int64_t(a.width) * a.height < std::int64_t(b.width) * b.height;
      });
  HalfSpectrum power{largest.width, largest.height, {}};
  power.values.resize(std::size_t(power.columns()) * std::size_t(power.height));
  for (const MapExemplar& map : maps) {
    if (map.width != power.width || map.height != power.height)
      continue;
    const std::size_t channels = map.channels.size();
    std::vector<double> own(power.values.size());
    double sum = 0.0;
    for (std::size_t c = 0; c < channels; ++c) {
      std::vector<float> plane;
      for (std::size_t i = c; i < map.values.size(); i += channels)
        plane.push_back(map.values[i]);
      const HalfSpectrum spectrum = forwardFft(plane, map.width, map.height);
      for (std::size_t i = 1; i < own.size(); ++i) {
        const double value = std::norm(spectrum.values[i]);
        own[i] += value;
        sum += value;
      }
    }
    for (std::size_t i = 0; i < own.size() && sum > 0.0; ++i)
      power.values[i] += float(own[i] / sum);
  }
  return power;
}

/// Slow variation correlates everything, and says nothing about periods.
void dropSlowVariation(HalfSpectrum& power) {
  constexpr double kDeviation = 0.12; // of the Gaussian that is taken away, over a mean side
  const double pixels = kDeviation * std::sqrt(double(power.width) * power.height);
  for (int row = 0; row < power.height; ++row)
    for (int u = 0; u < power.columns(); ++u) {
      const double x = double(u) / power.width, y = double(power.signedRow(row)) / power.height;
      const double squared = std::pow(std::numbers::pi * pixels, 2.0) * (x * x + y * y);
      power.at(u, row) *= float(std::pow(1.0 - std::exp(-2.0 * squared), 2.0));
    }
}

/// The power of a random field with the same spectrum averaged over near frequencies.
HalfSpectrum randomPower(const HalfSpectrum& power) {
  constexpr int kReach = 4;
  const int width = power.width, height = power.height;
  const auto at = [&](int u, int v) {
    u = (u % width + width) % width;
    v = (v % height + height) % height;
    if (2 * u > width) { // the mirror
      u = width - u;
      v = (height - v) % height;
    }
    return double(power.at(u, v).real());
  };
  // Sums over columns, then over rows.
  const auto columns = std::size_t(power.columns());
  std::vector<double> across(power.values.size());
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < int(columns); ++u)
      for (int k = -kReach; k <= kReach; ++k)
        across[std::size_t(v) * columns + std::size_t(u)] += at(u + k, v);
  HalfSpectrum result = power;
  Generator generator(1u);
  for (int v = 0; v < height; ++v)
    for (std::size_t u = 0; u < columns; ++u) {
      double sum = 0.0;
      for (int k = -kReach; k <= kReach; ++k)
        sum += across[std::size_t((v + k + height) % height) * columns + u];
      // The power of a frequency of a random field is distributed exponentially.
      result.at(int(u), v) = float(-sum * std::log1p(-generator.next()));
    }
  for (int v = height / 2 + 1; v < height; ++v)
    result.at(0, v) = result.at(0, height - v);
  result.at(0, 0) = 0.0f;
  return result;
}

Autocorrelation autocorrelationOf(const HalfSpectrum& power) {
  Autocorrelation result{power.width, power.height, inverseFft(power)};
  const float variance = result.values[0];
  for (float& value : result.values)
    value = variance > 0.0f ? value / variance : 0.0f;
  return result;
}

/// The same field on fewer pixels, at most kMostSide a side: the draw visits all of them each time.
HalfSpectrum reduced(const HalfSpectrum& power) {
  constexpr int kMostSide = 512;
  const int width = std::min(power.width, kMostSide), height = std::min(power.height, kMostSide);
  HalfSpectrum result{width, height, {}};
  result.values.resize(std::size_t(result.columns()) * std::size_t(height));
  for (int row = 0; row < height; ++row)
    for (int u = 0; u < result.columns(); ++u)
      result.at(u, row) = power.at(u, (result.signedRow(row) + power.height) % power.height);
  return result;
}

/// Draws shifts one after the other.
class Draw {
public:
  /// The density of a shift is exp(sharpness m), m its mean autocorrelation with those before it.
  Draw(const Autocorrelation& correlation, double sharpness)
      : correlation_(correlation), sharpness_(sharpness), sums_(correlation.values.size()),
        isFree_(correlation.values.size(), 1) {
    choose(0, 0);
  }

  [[nodiscard]] const std::vector<std::array<int, 2>>& shifts() const { return shifts_; }
  /// The mean autocorrelation of each shift with those before it.
  [[nodiscard]] const std::vector<double>& heights() const { return heights_; }

  /// Draws one more, whose mean autocorrelation is at most the highest. Returns false if none is
  /// free, or the highest is below `least`.
  [[nodiscard]] bool next(double least) {
    const auto count = float(shifts_.size());
    float highest = -1.0f;
    for (std::size_t i = 0; i < sums_.size(); ++i)
      if (isFree_[i] != 0)
        highest = std::max(highest, sums_[i] / count);
    if (highest <= -1.0f || double(highest) < least)
      return false;
    const auto densityAt = [&](std::size_t i) {
      constexpr double kNegligible = -30.0;
      const double exponent = sharpness_ * double(sums_[i] / count - highest);
      return isFree_[i] != 0 && exponent > kNegligible ? std::exp(exponent) : 0.0;
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < sums_.size(); ++i)
      sum += densityAt(i);
    double left = generator_.next() * sum;
    std::size_t chosen = sums_.size();
    for (std::size_t i = 0; i < sums_.size() && left >= 0.0; ++i)
      if (const double density = densityAt(i); density > 0.0) {
        left -= density;
        chosen = i;
      }
    heights_.push_back(double(sums_[chosen] / count));
    choose(int(chosen % std::size_t(correlation_.width)),
           int(chosen / std::size_t(correlation_.width)));
    return true;
  }

private:
  void choose(int x, int y) {
    constexpr double kApart = 0.075; // of a mean side; closer shifts would say the same
    const int width = correlation_.width, height = correlation_.height;
    const double radius = kApart * std::sqrt(double(width) * height);
    shifts_.push_back({x, y});
    std::size_t i = 0;
    for (int row = 0; row < height; ++row) {
      const int v = (row - y + height) % height, fromTop = std::min(v, height - v);
      for (int column = 0; column < width; ++column, ++i) {
        const int u = (column - x + width) % width, fromLeft = std::min(u, width - u);
        sums_[i] += correlation_.values[std::size_t(v) * std::size_t(width) + std::size_t(u)];
        if (fromTop < radius && fromLeft < radius && std::hypot(fromLeft, fromTop) < radius)
          isFree_[i] = 0;
      }
    }
  }

  const Autocorrelation& correlation_;
  double sharpness_;
  std::vector<float> sums_;
  std::vector<std::uint8_t> isFree_;
  std::vector<std::array<int, 2>> shifts_;
  std::vector<double> heights_{1.0};
  Generator generator_{2u};
};

/// The mean height of the shifts 4 to 9, of a draw that takes nearly the highest each time.
double meanHeight(const Autocorrelation& correlation) {
  constexpr double kSharpness = 400.0;
  constexpr std::size_t kFirst = 3, kEnd = 9;
  Draw draw(correlation, kSharpness);
  while (draw.shifts().size() < kEnd)
    if (!draw.next(-1.0))
      return 0.0;
  double sum = 0.0;
  for (std::size_t k = kFirst; k < kEnd; ++k)
    sum += draw.heights()[k];
  return sum / double(kEnd - kFirst);
}

double smoothStep(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Shifts of a reduced autocorrelation -> shifts of the whole one nearby that repeat the exemplar
/// best, together with all before them.
std::vector<std::array<int, 2>> refined(const std::vector<std::array<int, 2>>& shifts,
                                        const Autocorrelation& reduced,
                                        const Autocorrelation& whole) {
  const double scaleX = double(whole.width) / reduced.width;
  const double scaleY = double(whole.height) / reduced.height;
  const auto wrapped = [](int value, int side) { return (value % side + side) % side; };
  std::vector<std::array<int, 2>> result{{0, 0}};
  for (std::size_t k = 1; k < shifts.size(); ++k) {
    const int x = int(std::lround(shifts[k][0] * scaleX)), reachX = int(std::ceil(scaleX)) - 1;
    const int y = int(std::lround(shifts[k][1] * scaleY)), reachY = int(std::ceil(scaleY)) - 1;
    std::array<int, 2> best{x, y};
    double highest = -1e30;
    for (int v = y - reachY; v <= y + reachY; ++v)
      for (int u = x - reachX; u <= x + reachX; ++u) {
        double sum = 0.0;
        for (const std::array<int, 2>& before : result)
          sum += double(whole.values[std::size_t(wrapped(v - before[1], whole.height)) *
                                         std::size_t(whole.width) +
                                     std::size_t(wrapped(u - before[0], whole.width))]);
        if (sum > highest) {
          highest = sum;
          best = {wrapped(u, whole.width), wrapped(v, whole.height)};
        }
      }
    result.push_back(best);
  }
  return result;
}

} // namespace

NearPeriods nearPeriods(std::span<const MapExemplar> maps, std::size_t most,
                        std::optional<double> guide) {
  // Twelve exemplars: bricks have an excess of 0.78, ripples 0.43, wood 0.21, moss and dirt less
  // than 0.04.
  constexpr double kRandom = 0.08, kRegular = 0.30, kLeastStrength = 0.05;
  HalfSpectrum whole = powerOf(maps);
  dropSlowVariation(whole);
  const HalfSpectrum power = reduced(whole);
  const Autocorrelation correlation = autocorrelationOf(power);
  const double excess = meanHeight(correlation) - meanHeight(autocorrelationOf(randomPower(power)));
  NearPeriods result;
  if (const double strength = smoothStep(kRandom, kRegular, excess); strength >= kLeastStrength)
    result.strength = strength;
  const double closeness = guide.value_or(result.strength);
  if (closeness == 0.0)
    return result;
  constexpr double kSharpness = 300.0, kLeastHeight = 0.75;
  // A further shift needs kLeastHeight of the median height of shifts 3 to 9.
  constexpr std::ptrdiff_t kFirst = 2, kEnd = 9;
  Draw draw(correlation, kSharpness * closeness);
  while (draw.shifts().size() < most) {
    double least = -1.0;
    if (draw.heights().size() >= std::size_t(kEnd)) {
      least = kLeastHeight * closeness *
              exemplar::quantile(std::vector<double>(draw.heights().begin() + kFirst,
                                                     draw.heights().begin() + kEnd),
                                 0.5);
    }
    if (!draw.next(least))
      break;
  }
  if (draw.shifts().size() < kFewestShifts)
    return result;
  for (const std::array<int, 2>& shift :
       refined(draw.shifts(), correlation, autocorrelationOf(whole))) {
    const auto toTiles = [](int pixels, int side) {
      return (2 * pixels < side ? pixels : pixels - side) / double(side);
    };
    result.shifts.push_back({toTiles(shift[0], whole.width), toTiles(shift[1], whole.height)});
  }
  return result;
}

} // namespace lichen::placement
