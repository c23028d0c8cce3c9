// SPDX-License-Identifier: MIT
// Maps (height, width, channels each) -> the same maps with what they show only once, such as a
// leaf, a fold or a stain, replaced by other parts of their own.
//
// Colours (height, width, channels) -> the part that stands out, through the Mahalanobis distance
// of differences of Gaussians at four scales.
#include "color_space.h"
#include "low_pass.h"
#include "progress_part.h"
#include "resample.h"
#include "value_encoding.h"

#include <lichen/exemplar_repair.h>
#include <lichen/fft.h>
#include <lichen/image.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lichen {
namespace {

using namespace exemplar;

/// Part of an exemplar, in pixels.
struct Part {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// The map at most 256 pixels long, and what stands out in it.
struct Outlier {
  MapExemplar reduced;
  Part part;                 ///< of the reduced map, with a margin of half the scale
  std::vector<bool> unusual; ///< reduced pixels that differ nearly as much as the third place
};

/// How much further than the third strongest place something that occurs once stands out. The
/// geometric mean of 2.4 and 3.0 in docs/decisions/005-exemplar.md.
inline constexpr double kOutlier = 2.7;

/// The least difference of an outlier from its surroundings, in sRGB codes from 0 to 1, root mean
/// square over the channels: 2.5 codes of 8 bits.
inline constexpr double kVisibleOutlier = 0.01;

constexpr int kSmallestSide = 128;
constexpr int kSearchSide = 256;         // longer side of the map that is searched
constexpr int kSmallestReducedSide = 64; // four times the largest scale

/// The scales, as divisors of the longer side.
constexpr std::array<double, 4> kScales{64.0, 40.0, 25.0, 16.0};

// Standard deviations of the Gaussians, in scales.
constexpr double kPlace = 0.5, kSurroundings = 3.0;

/// A channel in sRGB codes, without its trend.
Plane codesOf(const MapExemplar& map, std::size_t channel) {
  Plane plane{map.width, map.height, {}};
  for (std::size_t i = channel; i < map.values.size(); i += map.channels.size())
    plane.values.push_back(linearToSrgb(decoded(map.values[i], map.encoding)));
  const Plane trend = trendOf(plane, false);
  for (std::size_t i = 0; i < plane.values.size(); ++i)
    plane.values[i] -= trend.values[i];
  return plane;
}

/// What the difference of Gaussians leaves of each wave of the spectrum, in its order.
std::vector<float> gainsAt(double scale, const HalfSpectrum& spectrum) {
  std::vector<float> gains;
  gains.reserve(spectrum.values.size());
  for (int v = 0; v < spectrum.height; ++v)
    for (int u = 0; u < spectrum.columns(); ++u) {
      const double turn =
          2.0 * std::numbers::pi * scale *
          std::hypot(double(u) / spectrum.width, double(spectrum.signedRow(v)) / spectrum.height);
      const auto gain = [&](double deviation) {
        return std::exp(-0.5 * deviation * deviation * turn * turn);
      };
      gains.push_back(float(gain(kPlace) - gain(kSurroundings)));
    }
  return gains;
}

/// The differences of all places from their surroundings: (pixels, channels).
Eigen::MatrixXd differences(std::span<const HalfSpectrum> channels, int width, int height,
                            double scale) {
  Eigen::MatrixXd result(Eigen::Index(width) * height, Eigen::Index(channels.size()));
  const std::vector<float> gains = gainsAt(scale, channels.front());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    HalfSpectrum band = channels[c];
    for (std::size_t i = 0; i < gains.size(); ++i)
      band.values[i] *= gains[i];
    const std::vector<float> plane = inverseFft(band);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        result(Eigen::Index(y) * width + x, Eigen::Index(c)) =
            double(plane[std::size_t(y) * std::size_t(band.width) + std::size_t(x)]);
  }
  return result;
}

/// The Mahalanobis distance of each row from 0. The covariance is taken over the rows with all but
/// the 2 % largest distances, by iteration, plus the variance of rounding to 8 bits.
std::vector<float> distances(const Eigen::MatrixXd& rows) {
  constexpr double kUsual = 0.98, kRounding = 1.0 / 255.0 / 255.0 / 12.0;
  const Eigen::Index channels = rows.cols();
  std::vector<double> squares(std::size_t(rows.rows()), 0.0);
  double most = 0.0;
  for (int iteration = 0; iteration < 3; ++iteration) {
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(channels, channels);
    double count = 0.0;
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      if (squares[std::size_t(i)] <= most) {
        covariance += rows.row(i).transpose() * rows.row(i);
        count += 1.0;
      }
    covariance = covariance / count + kRounding * Eigen::MatrixXd::Identity(channels, channels);
    const Eigen::MatrixXd scaled = covariance.ldlt().solve(rows.transpose()).transpose();
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      squares[std::size_t(i)] = scaled.row(i).dot(rows.row(i));
    most = quantile(squares, kUsual);
  }
  std::vector<float> result;
  for (const double square : squares)
    result.push_back(float(std::sqrt(std::max(square, 0.0))));
  return result;
}

/// The pixels above `level` that are connected with pixel `from` along rows and columns.
std::vector<std::size_t> connected(const std::vector<float>& values, int width, std::size_t from,
                                   float level) {
  std::vector<bool> seen(values.size());
  std::vector<std::size_t> found{from};
  seen[from] = true;
  const auto side = std::size_t(width);
  for (std::size_t next = 0; next < found.size(); ++next) {
    const std::size_t pixel = found[next];
    const auto visit = [&](bool exists, std::size_t neighbour) {
      if (!exists || seen[neighbour] || values[neighbour] <= level)
        return;
      seen[neighbour] = true;
      found.push_back(neighbour);
    };
    visit(pixel % side > 0, pixel - 1);
    visit(pixel % side + 1 < side, pixel + 1);
    visit(pixel >= side, pixel - side);
    visit(pixel + side < values.size(), pixel + side);
  }
  return found;
}

/// Sets the values in and around the pixels to 0.
void erase(std::vector<float>& values, int width, std::span<const std::size_t> pixels,
           int distance) {
  const int height = int(values.size()) / width;
  for (const std::size_t pixel : pixels) {
    const int px = int(pixel) % width, py = int(pixel) / width;
    for (int y = std::max(0, py - distance); y <= std::min(height - 1, py + distance); ++y)
      for (int x = std::max(0, px - distance); x <= std::min(width - 1, px + distance); ++x)
        values[std::size_t(y) * std::size_t(width) + std::size_t(x)] = 0.0f;
  }
}

/// A place that stands out at one scale.
struct Strongest {
  double ratio = 0.0;     ///< its distance over the third strongest place's
  std::size_t middle = 0; ///< the pixel that differs most
  Part part;
  std::vector<bool> unusual;
};

Strongest strongestAt(const std::vector<float>& distances, int width, double scale) {
  constexpr float kSamePlace = 0.45f; // share of a place's distance down to which it reaches
  constexpr double kApart = 1.5;      // scales between two places
  std::vector<float> left = distances;
  std::array<float, 3> places{};
  std::size_t first = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto most = std::size_t(std::ranges::max_element(left) - left.begin());
    places[k] = left[most];
    if (k == 0)
      first = most;
    erase(left, width, connected(left, width, most, kSamePlace * places[k]),
          int(std::lround(kApart * scale)));
  }
  if (!(places[2] > 0.0f))
    return {};
  constexpr float kUnusual = 0.8f; // of the third place's distance
  constexpr float kReach = 0.15f;  // of the first's: its surroundings differ from it, too
  const float unusualLevel = kUnusual * places[2];
  const float level = std::max(unusualLevel, kReach * places[0]);
  const int margin = int(std::lround(0.5 * scale)), height = int(distances.size()) / width;
  int fromX = width, fromY = height, toX = 0, toY = 0;
  for (const std::size_t pixel : connected(distances, width, first, level)) {
    const int x = int(pixel) % width, y = int(pixel) / width;
    fromX = std::min(fromX, x - margin);
    fromY = std::min(fromY, y - margin);
    toX = std::max(toX, x + margin + 1);
    toY = std::max(toY, y + margin + 1);
  }
  fromX = std::max(fromX, 0);
  fromY = std::max(fromY, 0);
  std::vector<bool> unusual(distances.size());
  std::transform(distances.begin(), distances.end(), unusual.begin(),
                 [&](float distance) { return distance > unusualLevel; });
  return {double(places[0] / places[2]),
          first,
          {fromX, fromY, std::min(toX, width) - fromX, std::min(toY, height) - fromY},
          std::move(unusual)};
}

/// The part of a colour map that stands out most from its surroundings, if nothing like it occurs
/// a third time. At four scales, from a 64th to a 16th of the longer side, every place is compared
/// with its surroundings by their difference in colour, in deviations of the differences elsewhere.
/// A place is an outlier if at some scale its difference is visible (kVisibleOutlier) and more than
/// kOutlier times the third strongest place's. Nothing for sides under 128 pixels, or longer than
/// four times the other. Throws std::bad_alloc.
std::optional<Outlier> outlierOf(const MapExemplar& map) {
  if (std::min(map.width, map.height) < kSmallestSide)
    return std::nullopt;
  const double reduction = std::min(1.0, double(kSearchSide) / std::max(map.width, map.height));
  const auto side = [&](int pixels) { return std::max(1, int(std::lround(reduction * pixels))); };
  MapExemplar reduced =
      reduction < 1.0 ? resampled(map, side(map.width), side(map.height), false) : map;
  if (std::min(reduced.width, reduced.height) < kSmallestReducedSide)
    return std::nullopt;
  std::vector<HalfSpectrum> channels;
  for (std::size_t c = 0; c < reduced.channels.size(); ++c) {
    const Plane whole = mirrored(codesOf(reduced, c));
    channels.push_back(forwardFft(whole.values, whole.width, whole.height));
  }
  Strongest best;
  for (const double divisor : kScales) {
    const double scale = std::max(reduced.width, reduced.height) / divisor;
    const Eigen::MatrixXd rows = differences(channels, reduced.width, reduced.height, scale);
    Strongest strongest = strongestAt(distances(rows), reduced.width, scale);
    const double difference = rows.row(Eigen::Index(strongest.middle)).norm();
    const double visible = kVisibleOutlier * std::sqrt(double(rows.cols()));
    if (strongest.ratio > best.ratio && difference >= visible)
      best = std::move(strongest);
  }
  if (best.ratio < kOutlier)
    return std::nullopt;
  return Outlier{std::move(reduced), best.part, std::move(best.unusual)};
}

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
  /// Whether the pixel lies on the edge, where both parts are blended.
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
  const auto [least, most] = rangeOf(map.values, map.channels.size(), channel);
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
    if (Result<void> checked = checkRanges(maps); !checked)
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
    if (Result<void> checked = checkRanges(maps); !checked)
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
