// SPDX-License-Identifier: MIT
// Maps (height, width, channels each) -> the same maps with parts replaced by others of their own.
#include "exemplar/map_ranges.h"
#include "outlier.h"
#include "progress_part.h"

#include <lichen/outliers.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace lichen {
namespace {

using namespace suitability;

constexpr std::size_t kMostOutliers = 4;
constexpr double kLargestShare = 1.0 / 8.0; // of the map's pixels

/// The weight of what replaces a part, at a pixel of it: 1 inside, and 0 at its edges, except at
/// those that are borders of a map that does not tile.
class Fade {
public:
  Fade(const MapExemplar& map, const Part& part, bool periodic)
      : part_(part), width_(std::max(1.0, std::min(part.width, part.height) / 6.0)),
        left_(periodic || part.x > 0), top_(periodic || part.y > 0),
        right_(periodic || part.x + part.width < map.width),
        bottom_(periodic || part.y + part.height < map.height) {}

  [[nodiscard]] float at(int x, int y) const {
    return along(left_, x) * along(right_, part_.width - 1 - x) * along(top_, y) *
           along(bottom_, part_.height - 1 - y);
  }
  /// Whether the pixel is one of both.
  [[nodiscard]] bool isEdge(int x, int y) const { return at(x, y) < 1.0f; }

private:
  [[nodiscard]] float along(bool fades, int pixelsInside) const {
    const double t = std::min(1.0, (pixelsInside + 0.5) / width_);
    return fades ? float(t * t * (3.0 - 2.0 * t)) : 1.0f;
  }

  Part part_;
  double width_;
  bool left_, top_, right_, bottom_;
};

std::size_t indexOf(const MapExemplar& map, int x, int y, std::size_t channel) {
  return (std::size_t(y) * std::size_t(map.width) + std::size_t(x)) * map.channels.size() + channel;
}

/// Means of a channel along the edges of two parts of the same size.
struct EdgeMeans {
  double here = 0.0;
  double there = 0.0;
};

EdgeMeans edgeMeans(const MapExemplar& map, const Part& part, const Fade& fade, int fromX,
                    int fromY, std::size_t channel) {
  EdgeMeans sum;
  double count = 0.0;
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      if (fade.isEdge(x, y)) {
        sum.here += double(map.values[indexOf(map, part.x + x, part.y + y, channel)]);
        sum.there += double(map.values[indexOf(map, fromX + x, fromY + y, channel)]);
        count += 1.0;
      }
  return count > 0.0 ? EdgeMeans{sum.here / count, sum.there / count} : sum;
}

void fillChannel(MapExemplar& map, const Part& part, int fromX, int fromY, const Fade& fade,
                 std::size_t channel) {
  const EdgeMeans means = edgeMeans(map, part, fade, fromX, fromY, channel);
  float least = map.values[channel], most = least;
  for (std::size_t i = channel; i < map.values.size(); i += map.channels.size()) {
    least = std::min(least, map.values[i]);
    most = std::max(most, map.values[i]);
  }
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x) {
      const float there = fade.at(x, y), here = 1.0f - there;
      float& value = map.values[indexOf(map, part.x + x, part.y + y, channel)];
      const float own = value - float(means.here);
      const float other =
          map.values[indexOf(map, fromX + x, fromY + y, channel)] - float(means.there);
      // The blend preserves the variance of independent values: [HN18] eq. 8.
      const float blend = (here * own + there * other) / std::hypot(here, there);
      value = std::clamp(float(means.here) + blend, least, most);
    }
}

/// The same shares of the sides of another map.
Part partOf(const FilledPlace& filled, const MapExemplar& map, const MapExemplar& first) {
  const auto [x, y, width, height] = filled.place;
  const auto scaled = [](std::uint32_t pixels, int side, int firstSide) {
    return int(std::lround(double(pixels) * side / firstSide));
  };
  const int fromX = std::min(scaled(x, map.width, first.width), map.width - 1);
  const int fromY = std::min(scaled(y, map.height, first.height), map.height - 1);
  return {fromX, fromY, std::max(1, scaled(x + width, map.width, first.width) - fromX),
          std::max(1, scaled(y + height, map.height, first.height) - fromY)};
}

void fillMap(MapExemplar& map, const FilledPlace& filled, const MapExemplar& first, bool periodic) {
  const Part part = partOf(filled, map, first);
  const auto source = [](std::uint32_t pixels, int side, int firstSide, int size) {
    return std::clamp(int(std::lround(double(pixels) * side / firstSide)), 0, side - size);
  };
  const int fromX = source(filled.from[0], map.width, first.width, part.width);
  const int fromY = source(filled.from[1], map.height, first.height, part.height);
  const Fade fade(map, part, periodic);
  for (std::size_t channel = 0; channel < map.channels.size(); ++channel)
    fillChannel(map, part, fromX, fromY, fade, channel);
}

/// How much two parts differ along their edges: mean square, with the means alike.
double edgeDifference(const MapExemplar& map, const Part& part, const Fade& fade, int fromX,
                      int fromY) {
  double sum = 0.0;
  for (std::size_t channel = 0; channel < map.channels.size(); ++channel) {
    const EdgeMeans means = edgeMeans(map, part, fade, fromX, fromY, channel);
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        if (fade.isEdge(x, y)) {
          const double difference =
              double(map.values[indexOf(map, fromX + x, fromY + y, channel)]) - means.there -
              double(map.values[indexOf(map, part.x + x, part.y + y, channel)]) + means.here;
          sum += difference * difference;
        }
  }
  return sum;
}

/// Where the part is replaced from, with the least difference along its edges; nothing if it is too
/// large.
std::optional<Part> sourceOf(const Outlier& outlier, bool periodic) {
  const MapExemplar& map = outlier.reduced;
  const Part& part = outlier.part;
  if (double(part.width) * part.height > kLargestShare * map.width * map.height)
    return std::nullopt;
  const auto isUsual = [&](int fromX, int fromY) {
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        if (outlier
                .unusual[std::size_t(fromY + y) * std::size_t(map.width) + std::size_t(fromX + x)])
          return false;
    return true;
  };
  const Fade fade(map, part, periodic);
  const int step = std::max(1, std::min(part.width, part.height) / 8);
  double least = std::numeric_limits<double>::max();
  std::optional<Part> best;
  for (int y = 0; y + part.height <= map.height; y += step)
    for (int x = 0; x + part.width <= map.width; x += step) {
      const bool overlaps = std::abs(x - part.x) < part.width && std::abs(y - part.y) < part.height;
      if (overlaps || !isUsual(x, y))
        continue;
      if (const double difference = edgeDifference(map, part, fade, x, y); difference < least) {
        least = difference;
        best = Part{x, y, part.width, part.height};
      }
    }
  return best;
}

/// A part of the reduced map in pixels of the whole.
std::array<std::uint32_t, 4> enlarged(const Part& part, const MapExemplar& reduced,
                                      const MapExemplar& whole) {
  const auto column = [&](int x) { return std::lround(double(x) * whole.width / reduced.width); };
  const auto row = [&](int y) { return std::lround(double(y) * whole.height / reduced.height); };
  return {std::uint32_t(column(part.x)), std::uint32_t(row(part.y)),
          std::uint32_t(column(part.x + part.width) - column(part.x)),
          std::uint32_t(row(part.y + part.height) - row(part.y))};
}

Outliers fillAll(std::span<MapExemplar> maps, bool periodic, ProgressPart progress) {
  const MapExemplar& first = maps.front();
  Outliers outliers;
  for (std::size_t k = 0; k < kMostOutliers; ++k) {
    progress.reach(double(k) / kMostOutliers);
    const std::optional<Outlier> outlier = outlierOf(first);
    if (!outlier)
      break;
    FilledPlace filled{enlarged(outlier->part, outlier->reduced, first), {}};
    const std::optional<Part> source = sourceOf(*outlier, periodic);
    if (!source) {
      outliers.left = filled.place;
      break;
    }
    const auto from = enlarged(*source, outlier->reduced, first);
    filled.from = {from[0], from[1]};
    outliers.filled.push_back(filled);
    for (MapExemplar& map : maps)
      fillMap(map, filled, first, periodic);
  }
  return outliers;
}

std::string exhausted() { return "not enough memory to fill outliers"; }

} // namespace

Result<Outliers> fillOutliers(std::span<MapExemplar> maps, bool periodic,
                              const Progress& progress) {
  return withinMemory(exhausted, [&]() -> Result<Outliers> {
    if (Result<void> checked = exemplar::checkRanges(maps); !checked)
      return checked.error();
    if (maps.front().target != MapTarget::baseColor)
      return Error{ErrorKind::usage, "the first map is no base colour, where outliers are found"};
    return unlessInterrupted("filling outliers", [&]() -> Result<Outliers> {
      return fillAll(maps, periodic, ProgressPart(progress));
    });
  });
}

Result<void> fillPlaces(std::span<MapExemplar> maps, std::span<const FilledPlace> places,
                        bool periodic) {
  return withinMemory(exhausted, [&]() -> Result<void> {
    if (Result<void> checked = exemplar::checkRanges(maps); !checked)
      return checked;
    const auto width = std::uint32_t(maps.front().width),
               height = std::uint32_t(maps.front().height);
    for (const FilledPlace& filled : places) {
      const auto [x, y, w, h] = filled.place;
      const auto fits = [](std::uint32_t from, std::uint32_t size, std::uint32_t side) {
        return size >= 1 && size <= side && from <= side - size;
      };
      if (!fits(x, w, width) || !fits(y, h, height) || !fits(filled.from[0], w, width) ||
          !fits(filled.from[1], h, height))
        return Error{ErrorKind::usage,
                     "a part of " + std::to_string(w) + " x " + std::to_string(h) + " pixels at " +
                         std::to_string(x) + ", " + std::to_string(y) + ", replaced from " +
                         std::to_string(filled.from[0]) + ", " + std::to_string(filled.from[1]) +
                         "; expected both inside the exemplar's " + std::to_string(width) + " x " +
                         std::to_string(height)};
      for (MapExemplar& map : maps)
        fillMap(map, filled, maps.front(), periodic);
    }
    return {};
  });
}

} // namespace lichen
