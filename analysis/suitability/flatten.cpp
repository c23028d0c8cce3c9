// SPDX-License-Identifier: MIT
// Maps (height, width, channels each) -> the same maps without their slow variation.
#include "exemplar/map_ranges.h"
#include "exemplar/value_encoding.h"
#include "flatten_map.h"
#include "low_pass.h"
#include "progress_part.h"
#include "trend.h"

#include <lichen/flatten.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace lichen {
namespace {

using namespace suitability;

/// Where the low-passed light is below this share of the mean, it is brightened only as much as at
/// this share. More would make its grain coarser than the rest's.
constexpr float kDarkestShare = 1.0f / 8.0f;

float mean(const std::vector<float>& values) {
  return float(std::accumulate(values.begin(), values.end(), 0.0) / double(values.size()));
}

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
  float least = map.values[channel], most = least;
  for (std::size_t i = channel; i < map.values.size(); i += map.channels.size()) {
    least = std::min(least, map.values[i]);
    most = std::max(most, map.values[i]);
  }
  if (!isLight(map))
    return {least, most};
  const float white =
      map.encoding == ValueEncoding::log2 ? exemplar::encoded(kHalfMax, map.encoding) : 1.0f;
  return {std::min(least, 0.0f), std::max(most, white)};
}

/// One channel, decoded.
Plane planeOf(const MapExemplar& map, std::size_t channel) {
  Plane plane{map.width, map.height, {}};
  plane.values.reserve(map.values.size() / map.channels.size());
  for (std::size_t i = channel; i < map.values.size(); i += map.channels.size())
    plane.values.push_back(exemplar::decoded(map.values[i], map.encoding));
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
        std::clamp(exemplar::encoded(plane.values[pixel], map.encoding), least, most);
  return range;
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
    if (Result<void> checked = exemplar::checkRanges(maps); !checked)
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

namespace suitability {

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

} // namespace suitability

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

} // namespace lichen
