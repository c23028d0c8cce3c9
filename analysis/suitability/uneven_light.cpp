// SPDX-License-Identifier: MIT
// Base colour (height, width, channels) -> the same without uneven light.
#include "calibration.h"
#include "edge_concentration.h"
#include "exemplar/map_ranges.h"
#include "exemplar/resample.h"
#include "exemplar/value_encoding.h"
#include "flatten_map.h"
#include "patches.h"

#include <lichen/flatten.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lichen {
namespace {

using namespace suitability;

/// The period is searched on a smaller map: all that is measured has at most 16 cycles per side.
constexpr int kSearchSide = 256;

MapExemplar reduced(const MapExemplar& map, bool periodic) {
  const double scale = double(kSearchSide) / std::max(map.width, map.height);
  if (scale >= 1.0)
    return map;
  const auto side = [&](int pixels) { return std::max(1, int(std::lround(scale * pixels))); };
  return exemplar::resampled(map, side(map.width), side(map.height), periodic);
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
  const MapExemplar parts = exemplar::resampled(map, kParts, kParts, false);
  const std::size_t channels = map.channels.size();
  std::vector<double> means(channels);
  const auto light = [&](std::size_t i) {
    return double(exemplar::decoded(parts.values[i], map.encoding));
  };
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
  const auto exhausted = [] { return "not enough memory to flatten the exemplar"; };
  return withinMemory(exhausted, [&]() -> Outcome {
    if (Result<void> checked = exemplar::checkRanges(map); !checked)
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
