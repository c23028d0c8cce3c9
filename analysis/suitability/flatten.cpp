// SPDX-License-Identifier: MIT
// Maps (height, width, channels each) -> the same without their slow variation.
#include "calibration.h"
#include "cloudiness.h"
#include "gaussian_plane.h"
#include "high_pass.h"
#include "slow_variation.h"
#include "tiling/map_ranges.h"
#include "tiling/value_encoding.h"

#include <lichen/fft.h>
#include <lichen/flatten.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lichen {
namespace {

using namespace suitability;

/// What is darker on the whole than this share of the mean is brightened as if it were that: its
/// grain would be coarser than the rest's.
constexpr float kDarkestShare = 1.0f / 8.0f;

/// One channel of an image.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// A period along each axis, pixels.
struct Period {
  double x = 0.0;
  double y = 0.0;
};

/// The plane beside its mirror images: periodic, and continuous at the borders.
Plane mirrored(const Plane& plane) {
  Plane whole{2 * plane.width, 2 * plane.height, {}};
  whole.values.reserve(4 * plane.values.size());
  for (int y = 0; y < whole.height; ++y) {
    const int from = y < plane.height ? y : whole.height - 1 - y;
    const auto row = plane.values.begin() + std::ptrdiff_t(from) * plane.width;
    whole.values.insert(whole.values.end(), row, row + plane.width);
    whole.values.insert(whole.values.end(), std::make_reverse_iterator(row + plane.width),
                        std::make_reverse_iterator(row));
  }
  return whole;
}

Plane lowPassed(const Plane& plane, const Period& period, bool periodic) {
  if (!periodic) {
    const Plane whole = lowPassed(mirrored(plane), period, true);
    Plane quarter{plane.width, plane.height, {}};
    quarter.values.reserve(plane.values.size());
    for (int y = 0; y < plane.height; ++y) {
      const auto row = whole.values.begin() + std::ptrdiff_t(y) * whole.width;
      quarter.values.insert(quarter.values.end(), row, row + plane.width);
    }
    return quarter;
  }
  HalfSpectrum spectrum = forwardFft(plane.values, plane.width, plane.height);
  for (int v = 0; v < spectrum.height; ++v) {
    const int signedV = spectrum.signedRow(v);
    for (int u = 0; u < spectrum.columns(); ++u)
      spectrum.at(u, v) *=
          float(lowPassGain(period.x * u / spectrum.width, period.y * signedV / spectrum.height));
  }
  return {plane.width, plane.height, inverseFft(spectrum)};
}

float mean(const std::vector<float>& values) {
  return float(std::accumulate(values.begin(), values.end(), 0.0) / double(values.size()));
}

/// Divides light by its low-passed self, and keeps the mean.
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

/// What the channel's stored values may become: light up to white, data within its own range,
/// slopes anything.
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
      map.encoding == ValueEncoding::log2 ? tiling::encoded(kHalfMax, map.encoding) : 1.0f;
  return {std::min(least, 0.0f), std::max(most, white)};
}

void flattenChannel(MapExemplar& map, std::size_t channel, const Period& period, bool periodic) {
  const std::size_t channels = map.channels.size();
  Plane plane{map.width, map.height, {}};
  plane.values.reserve(map.values.size() / channels);
  for (std::size_t i = channel; i < map.values.size(); i += channels)
    plane.values.push_back(tiling::decoded(map.values[i], map.encoding));
  const Plane slow = lowPassed(plane, period, periodic);
  if (isLight(map))
    evenOut(plane.values, slow.values);
  else
    subtract(plane.values, slow.values);
  const auto [least, most] = storedRange(map, channel);
  for (std::size_t pixel = 0; pixel < plane.values.size(); ++pixel)
    map.values[pixel * channels + channel] =
        std::clamp(tiling::encoded(plane.values[pixel], map.encoding), least, most);
}

/// As flatten(), of maps in range, but throws std::bad_alloc.
void flattenMaps(std::span<MapExemplar> maps, double periodPixels, bool periodic) {
  const MapExemplar& first = maps.front();
  for (MapExemplar& map : maps) {
    if (map.target == MapTarget::opacity)
      continue;
    const Period period{periodPixels * map.width / first.width,
                        periodPixels * map.height / first.height};
    for (std::size_t channel = 0; channel < map.channels.size(); ++channel)
      flattenChannel(map, channel, period, periodic);
  }
}

bool isCalm(const MapExemplar& map, bool periodic) {
  if (slowVariation(map) >= kSlowVariation.mild)
    return false;
  const std::optional<GaussianPlane> plane = gaussianPlane(map, periodic);
  return !plane ||
         cloudiness(forwardFft(plane->values, plane->width, plane->height)) < kCloudiness.mild;
}

/// As flatteningPeriod(), of a map in range, but throws std::bad_alloc.
std::optional<double> longestCalmingPeriod(const MapExemplar& map, bool periodic) {
  if (isCalm(map, periodic))
    return std::nullopt;
  const double side = std::max(map.width, map.height);
  const auto period = [&](int step) { return 2.0 * side * std::exp2(-0.5 * step); };
  const auto calms = [&](int step) {
    MapExemplar flattened = map;
    flattenMaps({&flattened, 1}, period(step), periodic);
    return isCalm(flattened, periodic);
  };
  // The first step that calms, by bisection: shorter periods calm more.
  int last = 0;
  while (period(last + 1) >= std::max(kShortestAutoPeriod * side, kFlattenPeriodRange.least))
    ++last;
  if (period(last) < kFlattenPeriodRange.least || !calms(last))
    return std::nullopt;
  int first = 0;
  while (first < last) {
    const int middle = (first + last) / 2;
    if (calms(middle))
      last = middle;
    else
      first = middle + 1;
  }
  return std::min(period(last), kFlattenPeriodRange.most);
}

std::string exhausted() { return "not enough memory to flatten the exemplar"; }

} // namespace

Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic) {
  return withinMemory(exhausted, [&]() -> Result<void> {
    if (maps.empty())
      return Error{ErrorKind::usage, "no map to flatten: at least one is needed"};
    for (const MapExemplar& map : maps)
      if (Result<void> checked = tiling::checkRanges(map); !checked)
        return checked;
    if (!(periodPixels >= kFlattenPeriodRange.least && periodPixels <= kFlattenPeriodRange.most))
      return Error{ErrorKind::usage, "a period of " + std::to_string(periodPixels) +
                                         " pixels: 4 to 16384 are accepted"};
    flattenMaps(maps, periodPixels, periodic);
    return {};
  });
}

Result<std::optional<double>> flatteningPeriod(const MapExemplar& map, bool periodic) {
  return withinMemory(exhausted, [&]() -> Result<std::optional<double>> {
    if (Result<void> checked = tiling::checkRanges(map); !checked)
      return checked.error();
    return longestCalmingPeriod(map, periodic);
  });
}

} // namespace lichen
