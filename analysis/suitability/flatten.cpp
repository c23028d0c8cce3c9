// SPDX-License-Identifier: MIT
// Maps (height, width, channels each) -> the same maps without their slow variation.
#include "as_seen.h"
#include "calibration.h"
#include "cloudiness.h"
#include "edge_concentration.h"
#include "exemplar/map_ranges.h"
#include "exemplar/value_encoding.h"
#include "gaussian_plane.h"
#include "low_pass.h"
#include "progress_part.h"
#include "slow_risks.h"

#include <lichen/fft.h>
#include <lichen/flatten.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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
void evenOut(std::vector<float>& light, const std::vector<float>& slow) {
  const float before = mean(light);
  if (!(before > 0.0f))
    return; // no light
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] *= before / std::max(slow[i], kDarkestShare * before);
  const float after = mean(light);
  for (float& value : light)
    value *= before / after;
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

void flattenChannel(MapExemplar& map, std::size_t channel, const Period& period, bool periodic) {
  const std::size_t channels = map.channels.size();
  Plane plane{map.width, map.height, {}};
  plane.values.reserve(map.values.size() / channels);
  for (std::size_t i = channel; i < map.values.size(); i += channels)
    plane.values.push_back(exemplar::decoded(map.values[i], map.encoding));
  const Plane slow = lowPassed(plane, period, periodic);
  if (isLight(map))
    evenOut(plane.values, slow.values);
  else
    subtract(plane.values, slow.values);
  const auto [least, most] = storedRange(map, channel);
  for (std::size_t pixel = 0; pixel < plane.values.size(); ++pixel)
    map.values[pixel * channels + channel] =
        std::clamp(exemplar::encoded(plane.values[pixel], map.encoding), least, most);
}

/// Like flatten(), for one map with values in range and a period in its own pixels. Throws.
void flattenMap(MapExemplar& map, const Period& period, bool periodic, ProgressPart progress) {
  if (map.target == MapTarget::opacity)
    return;
  for (std::size_t channel = 0; channel < map.channels.size(); ++channel) {
    progress.reach(double(channel) / double(map.channels.size()));
    flattenChannel(map, channel, period, periodic);
  }
}

/// The period that is the same share of the sides of `map` as `pixels` are of the sides of `first`.
Period periodOf(const MapExemplar& map, const MapExemplar& first, double pixels) {
  return {pixels * map.width / first.width, pixels * map.height / first.height};
}

/// The slow variation in a map, as the eye sees it.
struct SlowVariation {
  bool isRisk = false;  ///< low-frequency or cloudiness
  double patches = 0.0; ///< patchShare(); measured unless low-frequency is a risk

  [[nodiscard]] bool showsPatches() const { return isRisk || patches >= kVisiblePatches; }
};

SlowVariation slowVariationOf(const MapExemplar& map, bool periodic, ProgressPart progress) {
  const auto measured = [&](const MapExemplar& seen) {
    SlowVariation slow;
    slow.isRisk = !hasNoSlowRisk(seen, [&] {
      const std::optional<GaussianPlane> plane = gaussianPlane(seen, periodic, progress);
      if (!plane)
        return 0.0;
      const HalfSpectrum spectrum = forwardFft(plane->values, plane->width, plane->height);
      slow.patches = patchShare(spectrum);
      return cloudiness(spectrum);
    });
    return slow;
  };
  return map.target == MapTarget::height ? measured(slopesOfHeight(map, periodic)) : measured(map);
}

/// Share of the search's progress: one judgement of the unchanged map and at most five tries.
constexpr double kJudgement = 1.0 / 6.0;

/// The period for the map, if any, and the reason. Throws std::bad_alloc.
FlatteningChoice choosePeriod(const MapExemplar& map, bool periodic, ProgressPart progress) {
  if (!slowVariationOf(map, periodic, progress.part(0.0, kJudgement)).isRisk)
    return {FlatteningChoice::Reason::noRisk, std::nullopt, {}};
  progress.reach(kJudgement);
  if (edgeConcentration(map, periodic) > kEdgeConcentration)
    return {FlatteningChoice::Reason::object, std::nullopt, {}};
  const double side = std::max(map.width, map.height);
  const auto period = [&](int step) { return 2.0 * side * std::exp2(-0.5 * step); };
  double begin = kJudgement;
  const auto remaining = [&](int step) {
    const double end = std::min(1.0, begin + kJudgement), middle = 0.5 * (begin + end);
    MapExemplar flattened = map;
    flattenMap(flattened, periodOf(map, map, period(step)), periodic, progress.part(begin, middle));
    const SlowVariation slow = slowVariationOf(flattened, periodic, progress.part(middle, end));
    begin = end;
    return slow;
  };
  int last = 0;
  while (period(last + 1) >= std::max(kShortestAutoPeriod * side, kFlattenPeriodRange.least))
    ++last;
  if (period(last) < kFlattenPeriodRange.least || remaining(last).isRisk)
    return {FlatteningChoice::Reason::unresolved, std::nullopt, {}};
  // Bisection for the longest period that leaves no patches: shorter periods remove more. The
  // shortest may leave some.
  int first = 0;
  while (first < last) {
    const int middle = (first + last) / 2;
    if (remaining(middle).showsPatches())
      first = middle + 1;
    else
      last = middle;
  }
  return {
      FlatteningChoice::Reason::flattened, std::min(period(last), kFlattenPeriodRange.most), {}};
}

/// Like flattenAutomatically(), for maps with values in range, but throws.
FlatteningChoice flattenWhereNeeded(std::span<MapExemplar> maps, bool periodic,
                                    ProgressPart progress) {
  const MapExemplar& first = maps.front();
  const double each = 1.0 / double(maps.size() + 1); // the search is about as long as two maps
  FlatteningChoice choice = choosePeriod(first, periodic, progress.part(0.0, each));
  if (!choice.periodPixels)
    return choice;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const ProgressPart part = progress.part(double(m + 1) * each, double(m + 2) * each);
    const bool skips = maps[m].target == MapTarget::opacity;
    if (skips || (m > 0 && !slowVariationOf(maps[m], periodic, part.part(0.0, 0.5)).isRisk))
      continue;
    flattenMap(maps[m], periodOf(maps[m], first, *choice.periodPixels), periodic,
               part.part(0.5, 1.0));
    choice.flattened.push_back(maps[m].target);
  }
  return choice;
}

std::string exhausted() { return "not enough memory to flatten the exemplar"; }

Result<void> checkMaps(std::span<const MapExemplar> maps) {
  if (maps.empty())
    return Error{ErrorKind::usage, "no map to flatten; expected at least one"};
  for (const MapExemplar& map : maps)
    if (Result<void> checked = exemplar::checkRanges(map); !checked)
      return checked;
  return {};
}

template <class IsWanted>
Result<void> flattenWanted(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                           const IsWanted& isWanted, const Progress& progress) {
  return withinMemory(exhausted, [&]() -> Result<void> {
    if (Result<void> checked = checkMaps(maps); !checked)
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

Result<FlatteningChoice> flattenAutomatically(std::span<MapExemplar> maps, bool periodic,
                                              const Progress& progress) {
  return withinMemory(exhausted, [&]() -> Result<FlatteningChoice> {
    if (Result<void> checked = checkMaps(maps); !checked)
      return checked.error();
    return unlessInterrupted("flattening", [&]() -> Result<FlatteningChoice> {
      return flattenWhereNeeded(maps, periodic, ProgressPart(progress));
    });
  });
}

} // namespace lichen
