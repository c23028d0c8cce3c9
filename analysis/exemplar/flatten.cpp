// SPDX-License-Identifier: MIT
// Maps (height, width, channels each) -> the same maps without their slow variation.
#include "color_space.h"
#include "low_pass.h"
#include "progress_part.h"
#include "resample.h"
#include "value_encoding.h"

#include <lichen/exemplar_repair.h>
#include <lichen/fft.h>
#include <lichen/image.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace lichen {
namespace {

using namespace exemplar;

/// Where the low-passed light is below this share of the mean, it is brightened only as much as at
/// this share. More would make its grain coarser than the rest's.
constexpr float kDarkestShare = 1.0f / 8.0f;

float mean(const std::vector<float>& values) {
  return float(std::accumulate(values.begin(), values.end(), 0.0) / double(values.size()));
}

/// The light that was removed from a colour map, as shares of its mean; the mean over the channels.
struct LightRange {
  double darkest = 1.0;
  double brightest = 1.0;
};

/// Divides light by its low-passed copy and preserves the mean.
LightRange evenOut(std::vector<float>& light, const std::vector<float>& slow) {
  const float before = mean(light);
  if (!(before > 0.0f))
    return {}; // no light
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] *= before / std::max(slow[i], kDarkestShare * before);
  const float after = mean(light);
  for (float& value : light)
    value *= before / after;
  const auto [least, most] = std::minmax_element(slow.begin(), slow.end());
  return {double(std::max(*least / before, kDarkestShare)), double(*most / before)};
}

void subtract(std::vector<float>& values, const std::vector<float>& slow) {
  const float kept = mean(values);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] += kept - slow[i];
}

bool isLight(const MapExemplar& map) {
  return map.target == MapTarget::baseColor || map.target == MapTarget::emissive;
}

/// The range of the channel's flattened values: up to white for light, its own range for data, and
/// any half-precision value for slopes.
std::pair<float, float> storedRange(const MapExemplar& map, std::size_t channel) {
  if (map.encoding == ValueEncoding::slope)
    return {-kHalfMax, kHalfMax};
  const auto [least, most] = rangeOf(map.values, map.channels.size(), channel);
  if (!isLight(map))
    return {least, most};
  const float white = map.encoding == ValueEncoding::log2 ? encoded(kHalfMax, map.encoding) : 1.0f;
  return {std::min(least, 0.0f), std::max(most, white)};
}

/// One channel, decoded.
Plane planeOf(const MapExemplar& map, std::size_t channel) {
  Plane plane{map.width, map.height, {}};
  plane.values.reserve(map.values.size() / map.channels.size());
  for (std::size_t i = channel; i < map.values.size(); i += map.channels.size())
    plane.values.push_back(decoded(map.values[i], map.encoding));
  return plane;
}

/// The trend of the light that falls on all channels, of mean 1: each counts by its own mean.
Plane lightTrend(const MapExemplar& map, bool periodic) {
  Plane sum{map.width, map.height, std::vector<float>(map.values.size() / map.channels.size())};
  for (std::size_t channel = 0; channel < map.channels.size(); ++channel) {
    const Plane plane = planeOf(map, channel);
    const float level = float(map.channels.size()) * mean(plane.values);
    if (level > 0.0f)
      for (std::size_t i = 0; i < sum.values.size(); ++i)
        sum.values[i] += plane.values[i] / level;
  }
  return trendOf(sum, periodic);
}

/// Flattens one channel. `trend` is lightTrend() for maps of light, and empty for others.
LightRange flattenChannel(MapExemplar& map, std::size_t channel, const std::optional<Plane>& trend,
                          const Period& period, bool periodic) {
  const std::size_t channels = map.channels.size();
  Plane plane = planeOf(map, channel);
  LightRange range;
  if (trend) {
    Plane own = *trend;
    const float level = mean(plane.values);
    for (float& value : own.values)
      value *= level;
    range = evenOut(plane.values, lowPassed(plane, std::move(own), period, periodic).values);
  } else {
    subtract(plane.values, lowPassed(plane, trendOf(plane, periodic), period, periodic).values);
  }
  const auto [least, most] = storedRange(map, channel);
  for (std::size_t pixel = 0; pixel < plane.values.size(); ++pixel)
    map.values[pixel * channels + channel] =
        std::clamp(encoded(plane.values[pixel], map.encoding), least, most);
  return range;
}

/// Like flatten(), for one map with values in range and a period in its own pixels. Throws
/// Interrupted and std::bad_alloc.
LightRange flattenMap(MapExemplar& map, const Period& period, bool periodic,
                      ProgressPart progress) {
  if (map.target == MapTarget::opacity)
    return {};
  const auto channels = double(map.channels.size());
  const std::optional<Plane> trend =
      isLight(map) ? std::optional(lightTrend(map, periodic)) : std::nullopt;
  LightRange all{0.0, 0.0};
  for (std::size_t channel = 0; channel < map.channels.size(); ++channel) {
    progress.reach(double(channel) / channels);
    const LightRange range = flattenChannel(map, channel, trend, period, periodic);
    all = {all.darkest + range.darkest / channels, all.brightest + range.brightest / channels};
  }
  return all;
}

/// The period that is the same share of the sides of `map` as `pixels` are of the sides of `first`.
Period periodOf(const MapExemplar& map, const MapExemplar& first, double pixels) {
  return {pixels * map.width / first.width, pixels * map.height / first.height};
}

std::string exhausted() { return "not enough memory to flatten the exemplar"; }

template <class IsWanted>
Result<void> flattenWanted(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                           const IsWanted& isWanted, const Progress& progress) {
  return withinMemory(exhausted, [&]() -> Result<void> {
    if (Result<void> checked = checkRanges(maps); !checked)
      return checked;
    if (!(periodPixels >= kFlattenPeriodRange.least && periodPixels <= kFlattenPeriodRange.most))
      return Error{ErrorKind::usage,
                   "a period of " + std::to_string(periodPixels) + " pixels; expected 4 to 16384"};
    return unlessInterrupted("flattening", [&]() -> Result<void> {
      const auto count = double(maps.size());
      for (std::size_t m = 0; m < maps.size(); ++m)
        if (isWanted(maps[m].target))
          flattenMap(maps[m], periodOf(maps[m], maps.front(), periodPixels), periodic,
                     ProgressPart(progress).part(double(m) / count, double(m + 1) / count));
      return {};
    });
  });
}

} // namespace

Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                     const Progress& progress) {
  return flattenWanted(
      maps, periodPixels, periodic, [](MapTarget) { return true; }, progress);
}

Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                     std::span<const MapTarget> targets, const Progress& progress) {
  const auto isNamed = [&](MapTarget target) { return std::ranges::count(targets, target) > 0; };
  return flattenWanted(maps, periodPixels, periodic, isNamed, progress);
}

// Base colour (height, width, channels) -> the same without uneven light: it is found by the
// deviation of the patches in the noise.
namespace {

/// The deviation from which patches of the exemplar's size are visible, in sRGB codes from 0 to 1,
/// and their share of all deviation that shows from afar, which hides fainter ones. Measured by
/// looking, docs/decisions/006-light-and-grain.md.
inline constexpr double kVisiblePatches = 0.004;
inline constexpr double kVisiblePatchShare = 0.2;

/// Patches in the noise of a colour map. They show best from so far away that the exemplar covers
/// 32 pixels: nearer, grain hides them; farther, they are small themselves.
struct Patches {
  /// Standard deviation, in sRGB codes from 0 to 1, root mean square over the channels. Its square
  /// is the power of the eight waves of one cycle per side, (+-1, 0), (0, +-1) and (+-1, +-1), less
  /// twice the power of eight average waves of four cycles per side: a material's own variation has
  /// slow waves too, which chance makes twice as strong as others in 1 of 20 exemplars.
  double deviation = 0.0;
  double share = 0.0; ///< the deviation over all deviation that shows from this far

  [[nodiscard]] bool areVisible() const {
    return deviation >= kVisiblePatches && share >= kVisiblePatchShare;
  }
};

constexpr int kPatches = 1, kReference = 4; // cycles per side along the faster axis
constexpr int kSmallestSide = 16;           // two pixels in the waves of twice the reference
constexpr int kPixelsFromAfar = 32;         // along each side of the exemplar

/// Gain of averaging over a pixel from afar.
double gainFromAfar(int cycles) {
  const double x = std::numbers::pi * cycles / kPixelsFromAfar;
  return cycles == 0 ? 1.0 : std::sin(x) / x;
}

/// Energies, not normalised.
struct Energy {
  double patches = 0.0;
  double reference = 0.0;
  double fromAfar = 0.0;
};

void add(const HalfSpectrum& spectrum, Energy& energy) {
  for (int v = 0; v < spectrum.height; ++v)
    for (int u = 0; u < spectrum.columns(); ++u) {
      const int across = std::abs(spectrum.signedRow(v));
      const int cycles = std::max(u, across);
      if (cycles == 0)
        continue;
      const double power = spectrum.multiplicity(u) * double(std::norm(spectrum.at(u, v)));
      const double gain = gainFromAfar(u) * gainFromAfar(across);
      energy.fromAfar += gain * gain * power;
      if (cycles == kPatches)
        energy.patches += power;
      if (cycles == kReference)
        energy.reference += power;
    }
}

/// Zeros for sides under 16 pixels. Throws std::bad_alloc.
Patches patchesOf(const MapExemplar& map) {
  if (std::min(map.width, map.height) < kSmallestSide)
    return {};
  const std::size_t channels = map.channels.size();
  std::vector<float> codes(map.values.size() / channels);
  Energy energy;
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < codes.size(); ++i)
      codes[i] = linearToSrgb(exemplar::decoded(map.values[i * channels + c], map.encoding));
    add(forwardFft(codes, map.width, map.height), energy);
  }
  // A ring of n cycles has 8 n waves.
  const double own = energy.reference * kPatches / kReference;
  const double excess = std::max(0.0, energy.patches - 2.0 * own);
  const double pixels = double(map.width) * double(map.height);
  return {std::sqrt(excess / double(channels)) / pixels,
          energy.fromAfar > 0.0 ? std::sqrt(excess / energy.fromAfar) : 0.0};
}

/// The period is searched on a smaller map: all that is measured has at most 16 cycles per side.
constexpr int kSearchSide = 256;

MapExemplar reduced(const MapExemplar& map, bool periodic) {
  const double scale = double(kSearchSide) / std::max(map.width, map.height);
  if (scale >= 1.0)
    return map;
  const auto side = [&](int pixels) { return std::max(1, int(std::lround(scale * pixels))); };
  return resampled(map, side(map.width), side(map.height), periodic);
}

/// The map, flattened with a period that is a share of the longer side.
MapExemplar evened(MapExemplar map, bool periodic, double share) {
  const double period = share * std::max(map.width, map.height);
  flattenMap(map, {period, period}, periodic, {});
  return map;
}

/// Whether slow variation changes the hue: light and shadow hardly do.
bool isColored(const MapExemplar& map) {
  constexpr int kParts = 8;          // along each side
  constexpr double kColorful = 0.03; // share of the variance that differs between the channels
  const MapExemplar parts = resampled(map, kParts, kParts, false);
  const std::size_t channels = map.channels.size();
  std::vector<double> means(channels);
  const auto light = [&](std::size_t i) { return double(decoded(parts.values[i], map.encoding)); };
  for (std::size_t i = 0; i < parts.values.size(); ++i)
    means[i % channels] += light(i) / (kParts * kParts);
  double all = 0.0, color = 0.0;
  for (std::size_t part = 0; part < parts.values.size(); part += channels) {
    double shade = 0.0, squares = 0.0;
    for (std::size_t c = 0; c < channels; ++c) {
      const double change = means[c] > 0.0 ? light(part + c) / means[c] - 1.0 : 0.0;
      shade += change / double(channels);
      squares += change * change;
    }
    all += squares;
    color += squares - double(channels) * shade * shade;
  }
  return color > kColorful * all;
}

/// From twice the longer side on, flattening removes little more than the trend.
constexpr double kTrend = 2.0;

/// The longest period that leaves no patches of light, as a share of the longer side.
std::optional<double> shareFor(const MapExemplar& map, bool periodic) {
  const Patches patches = patchesOf(map);
  if (!patches.areVisible() || edgeConcentration(map, periodic) > kEdgeConcentration)
    return std::nullopt;
  const MapExemplar trendless = evened(map, periodic, kTrend);
  const Patches left = patchesOf(trendless);
  if (!periodic && !left.areVisible())
    return kTrend;
  // In an image that tiles, only a vignette is light. Chance gives the trend a third of the
  // variance.
  constexpr double kMostOfTile = 0.25, kMostOfColored = 0.75;
  if (periodic || isColored(trendless)) {
    const double most = (periodic ? kMostOfTile : kMostOfColored) * patches.deviation;
    return left.deviation < most ? std::optional(kTrend) : std::nullopt;
  }
  for (double share = kTrend / 2.0; share >= kShortestLight; share /= 2.0)
    if (!patchesOf(evened(map, periodic, share)).areVisible())
      return share;
  return std::nullopt;
}

} // namespace

Result<std::optional<RemovedLight>> removeUnevenLight(MapExemplar& map, bool periodic,
                                                      const Progress& progress) {
  using Outcome = Result<std::optional<RemovedLight>>;
  return withinMemory(exhausted, [&]() -> Outcome {
    if (Result<void> checked = checkRanges(map); !checked)
      return checked.error();
    return unlessInterrupted("flattening", [&]() -> Outcome {
      constexpr double kSearched = 0.3;
      const ProgressPart part(progress);
      part.reach(0.0);
      const std::optional<double> share = shareFor(reduced(map, periodic), periodic);
      part.reach(kSearched);
      if (!share)
        return std::optional<RemovedLight>();
      const double period = std::clamp(*share * std::max(map.width, map.height),
                                       kFlattenPeriodRange.least, kFlattenPeriodRange.most);
      const LightRange light =
          flattenMap(map, {period, period}, periodic, part.part(kSearched, 1.0));
      return std::optional(RemovedLight{period, light.darkest, light.brightest});
    });
  });
}

} // namespace lichen
