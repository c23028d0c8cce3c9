// SPDX-License-Identifier: MIT
// Maps -> the same, with pixels along borders that do not fit taken from a shift further.
// docs/decisions/012-quilting.md says how the constants were chosen.
#include "closed_borders.h"

#include "exemplar/color_space.h"
#include "exemplar/planes.h"
#include "placement/near_periods.h"
#include "placement/self_similarity.h"
#include "placement/whole_periods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace lichen::quilting {
namespace {

using Eigen::Index;

/// What a band is filled from. [tiles]
using Shift = std::array<double, 2>;

/// How far a position in the tile is from the borders across an axis. [tiles]
float fromBorder(float position) {
  const float share = position - std::floor(position);
  return std::min(share, 1.0f - share);
}

/// Half of a large cell: the 95 % quantile of the distances of texels from their centres. [tiles]
float halfCell(const CellField& cells, std::size_t axis) {
  constexpr double kLarge = 0.95;
  constexpr float kLeast = 1.0f / 64.0f, kMost = 1.0f / 8.0f;
  std::vector<float> distances;
  for (const std::array<float, 2>& vector : cells.toCentre)
    distances.push_back(std::abs(vector[axis]));
  return std::clamp(exemplar::quantile(std::move(distances), kLarge), kLeast, kMost);
}

/// The shift that repeats the exemplar and is nearest to half a tile along the axis. If none is
/// near, half a tile if edges fit loosely, otherwise nothing, and the border stays. Along x, closed
/// first, the shift is hardly across: it would bring the other border into the band.
std::optional<Shift> shiftAlong(std::size_t axis, const FittingShifts& fitting) {
  constexpr double kMostAlong = 0.25, kMostAcross = 1.0 / 32.0;
  constexpr double kAcrossLoss = 4.0;
  std::optional<Shift> best;
  if (!fitting.isClose())
    best = axis == 0 ? Shift{0.5, 0.0} : Shift{0.0, 0.5};
  double least = kMostAlong;
  for (const Shift& shift : fitting.shifts) {
    const double across = axis == 0 ? std::abs(shift[1]) : 0.0;
    const double loss = std::abs(std::abs(shift[axis]) - 0.5) + kAcrossLoss * across;
    if (across <= kMostAcross && loss < least) {
      least = loss;
      best = shift;
    }
  }
  return best;
}

/// Closes the borders across one axis: 0, x, or 1, y.
void closeAxis(std::span<MapExemplar> maps, const CellField& cells, std::size_t axis,
               const Shift& shift) {
  const float band = halfCell(cells, axis);
  const auto centreAt = [&](float x, float y) {
    const auto column = std::min(int(x * float(cells.width)), cells.width - 1);
    const auto row = std::min(int(y * float(cells.height)), cells.height - 1);
    const std::array<float, 2>& toCentre =
        cells.toCentre[std::size_t(row) * std::size_t(cells.width) + std::size_t(column)];
    // From the middle of the texel of cells, not of the pixel: the whole cell is on one side.
    return (axis == 0 ? (float(column) + 0.5f) / float(cells.width)
                      : (float(row) + 0.5f) / float(cells.height)) +
           toCentre[axis];
  };
  for (MapExemplar& map : maps) {
    const std::vector<float> original = map.values;
    const std::size_t channels = map.channels.size();
    const int shiftX = placement::pixelsOf(shift[0], map.width);
    const int shiftY = placement::pixelsOf(shift[1], map.height);
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
        const auto centre = [&](int column, int row) {
          return centreAt((float(column) + 0.5f) / float(map.width),
                          (float(row) + 0.5f) / float(map.height));
        };
        const int otherX = (x + shiftX) % map.width, otherY = (y + shiftY) % map.height;
        const float own = fromBorder(centre(x, y));
        const float other = fromBorder(centre(otherX, otherY) - float(shift[axis]));
        if (own + other >= 2.0f * band)
          continue;
        const std::size_t from =
            (std::size_t(otherY) * std::size_t(map.width) + std::size_t(otherX)) * channels;
        const std::size_t to =
            (std::size_t(y) * std::size_t(map.width) + std::size_t(x)) * channels;
        std::copy_n(&original[from], channels, &map.values[to]);
      }
  }
}

/// Shifts each channel to another mean, by its values between the least and the greatest: those
/// stay, such as the 0 and 1 of a mask. A channel of which most values are one of the two stays as
/// it is. Values that reach them stop there, so the mean is met nearly.
void shiftMeans(MapExemplar& map, const exemplar::ChannelVector& means) {
  const std::size_t channels = map.channels.size();
  const exemplar::ChannelVector own = exemplar::momentsOf(map.values, int(channels)).mean;
  std::vector<exemplar::ValueRange> ranges;
  for (std::size_t c = 0; c < channels; ++c)
    ranges.push_back(exemplar::rangeOf(map.values, channels, c));
  const auto isBetween = [&](std::size_t i) {
    return map.values[i] > ranges[i % channels].least && map.values[i] < ranges[i % channels].most;
  };
  std::vector<double> between(channels); // the share of such values
  for (std::size_t i = 0; i < map.values.size(); ++i)
    between[i % channels] += isBetween(i) ? double(channels) / double(map.values.size()) : 0.0;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const std::size_t c = i % channels;
    if (between[c] > 0.5 && isBetween(i))
      map.values[i] =
          std::clamp(map.values[i] + float((means[Index(c)] - own[Index(c)]) / between[c]),
                     ranges[c].least, ranges[c].most);
  }
}

/// Whether opposite borders across an axis look alike in all maps.
bool lookAlike(std::span<const MapExemplar> maps, std::size_t axis) {
  return std::ranges::all_of(maps, [&](const MapExemplar& map) {
    const exemplar::ImageLevel image = exemplar::reducedImage(map, placement::kMostPeriodSide);
    return placement::BorderMisfit(image).bordersLookAlike(axis);
  });
}

} // namespace

bool closeBorders(std::span<MapExemplar> maps, const CellField& cells, double count,
                  const FittingShifts& shifts, ProgressPart progress) {
  std::vector<exemplar::ChannelVector> means;
  for (const MapExemplar& map : maps)
    means.push_back(exemplar::momentsOf(map.values, int(map.channels.size())).mean);
  bool isClosed = false;
  for (const std::size_t axis : {std::size_t(0), std::size_t(1)}) {
    const std::optional<Shift> shift = shiftAlong(axis, shifts);
    if (shift && !lookAlike(maps, axis)) {
      closeAxis(maps, isClosed ? cellsOf(maps, count) : cells, axis, *shift);
      isClosed = true;
    }
    progress.reach(0.5 * double(axis + 1));
  }
  // What fills the bands may be brighter or darker than what it replaces.
  for (std::size_t m = 0; m < maps.size() && isClosed; ++m)
    shiftMeans(maps[m], means[m]);
  return isClosed;
}

} // namespace lichen::quilting
