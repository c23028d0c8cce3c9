// SPDX-License-Identifier: MIT
// Maps -> their part that becomes the tile, and a note.
#include "rectify_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace lichen::cli {
namespace {

/// Eight numbers from 0, with commas or spaces between them.
std::optional<TileCorners> cornersFrom(const std::string& text) {
  TileCorners corners{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t k = 0; k < 2 * corners.size(); ++k) {
    if (k > 0 && (at == end || std::string_view(", ").find(*at++) == std::string_view::npos))
      return std::nullopt;
    double& value = corners[k / 2][k % 2];
    const auto [rest, fault] = std::from_chars(at, end, value);
    if (fault != std::errc() || !(value >= 0.0))
      return std::nullopt;
    at = rest;
  }
  return at == end && areConvex(corners) ? std::optional(corners) : std::nullopt;
}

/// What a camera did to the tile, in degrees.
struct Distortion {
  double rotation = 0.0, shear = 0.0;
  double perspective = 0.0; ///< the greatest angle between opposite sides

  /// Beyond these the search may have taken other vectors than the material's rows: of eleven
  /// materials it does so with none that is turned by 10 degrees, with one to four by 14 to 24, and
  /// with all further on, mostly with a shear of 3 to 7 degrees.
  [[nodiscard]] bool isDoubtful() const {
    constexpr double kSureRotation = 15.0, kSureShear = 3.0;
    return std::abs(rotation) > kSureRotation || std::abs(shear) > kSureShear;
  }
};

Distortion distortionOf(const TileCorners& corners) {
  const auto degrees = [&](std::size_t from, std::size_t to) {
    return std::atan2(corners[to][1] - corners[from][1], corners[to][0] - corners[from][0]) *
           180.0 / std::numbers::pi;
  };
  const double upper = degrees(0, 1), lower = degrees(3, 2), left = degrees(0, 3),
               right = degrees(1, 2);
  const double rotation = 0.5 * (upper + lower);
  return {rotation, 0.5 * (left + right) - 90.0 - rotation,
          std::max(std::abs(upper - lower), std::abs(left - right))};
}

/// ", turned by 3.1 degrees, sheared by 0.5 degrees", as far as that is visible.
std::string wordsFor(const Distortion& distortion) {
  constexpr double kVisible = 0.25; // degrees
  std::vector<std::string> words;
  if (std::abs(distortion.rotation) > kVisible)
    words.push_back(fmt::format("turned by {:.1f} degrees", distortion.rotation));
  if (std::abs(distortion.shear) > kVisible)
    words.push_back(fmt::format("sheared by {:.1f} degrees", distortion.shear));
  if (distortion.perspective > kVisible)
    words.emplace_back("seen in perspective");
  return words.empty() ? "" : fmt::format(", {}", fmt::join(words, ", "));
}

} // namespace

Accepted<Rectification> rectification(bool findsPeriods) {
  return {findsPeriods ? "auto|off|X,Y,..." : "off|X,Y,...",
          std::string(findsPeriods ? "auto, off" : "off") +
              ", or 8 numbers from 0 with commas between them: X,Y of the upper left, upper right, "
              "lower right and lower left corner, in this order and in pixels; the corners must be "
              "convex",
          [findsPeriods](const std::string& text) -> std::optional<Rectification> {
            if (text == "auto" && findsPeriods)
              return Rectification{true, std::nullopt};
            if (text == "off")
              return Rectification{};
            const std::optional<TileCorners> corners = cornersFrom(text);
            return corners ? std::optional(Rectification{false, corners}) : std::nullopt;
          }};
}

Result<RectifiedPart> applyRectification(std::vector<MapExemplar>& maps, const Rectification& use,
                                         Periodic periodic, bool findsStructure,
                                         std::vector<std::string>& notes) {
  RectifiedPart part;
  const double width = maps.front().width;
  if (use.corners) {
    const MapExemplar& first = maps.front();
    for (const auto& [x, y] : *use.corners)
      if (x > first.width || y > first.height)
        return Error{ErrorKind::usage,
                     fmt::format("--rectify: the corner {:g},{:g} is outside the {} x {} pixels", x,
                                 y, first.width, first.height)};
    if (Result<void> made = rectify(maps, *use.corners); !made)
      return made.error();
    part.corners = use.corners;
    part.widthShare = maps.front().width / width;
  }
  if (!findsStructure)
    return part;
  Result<Structure> structure = structureOf(maps, periodic);
  if (!structure)
    return structure.error();
  part.structure = structure.value();
  if (!use.isAutomatic || !part.structure.wholePeriods)
    return part;
  part.corners = part.structure.wholePeriods;
  if (Result<void> made = rectify(maps, *part.corners); !made)
    return made.error();
  part.widthShare = maps.front().width / width;
  const Distortion distortion = distortionOf(*part.corners);
  notes.push_back(fmt::format(
      "the tile is the part of {} x {} pixels that holds whole periods{}; "
      "--rectify off keeps the whole picture{}",
      maps.front().width, maps.front().height, wordsFor(distortion),
      distortion.isDoubtful() ? "; this is at the limit of what is found, so check the tile: if "
                                "it is wrong, give its four corners to --rectify"
                              : ""));
  return part;
}

} // namespace lichen::cli
