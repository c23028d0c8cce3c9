// SPDX-License-Identifier: MIT
// Maps -> their part that becomes the tile, and a note.
#include "prepared_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

/// What a camera did to the tile, in degrees.
struct Distortion {
  double rotation = 0.0, shear = 0.0;
  double perspective = 0.0; ///< the greatest angle between opposite sides

  /// Beyond these the search may have taken other vectors than the material's rows: of eleven
  /// materials it does so with none that is rotated by 10 degrees, with one to four by 14 to 24,
  /// and with all by more, mostly with a shear of 3 to 7 degrees.
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

/// ", rotated by 3.1 degrees, sheared by 0.5 degrees", as far as that is visible.
std::string wordsFor(const Distortion& distortion) {
  constexpr double kVisible = 0.25; // degrees
  std::vector<std::string> words;
  if (std::abs(distortion.rotation) > kVisible)
    words.push_back(fmt::format("rotated by {:.1f} degrees", distortion.rotation));
  if (std::abs(distortion.shear) > kVisible)
    words.push_back(fmt::format("sheared by {:.1f} degrees", distortion.shear));
  if (distortion.perspective > kVisible)
    words.emplace_back("seen in perspective");
  return words.empty() ? "" : fmt::format(", {}", fmt::join(words, ", "));
}

} // namespace

Result<RectifiedPart> applyRectification(std::vector<MapExemplar>& maps, const Rectification& use,
                                         Periodic periodic, bool findsRegularity,
                                         SettingWords words, std::vector<std::string>& notes) {
  RectifiedPart part;
  const double width = maps.front().width;
  if (use.corners) {
    const MapExemplar& first = maps.front();
    for (const auto& [x, y] : *use.corners)
      if (x > first.width || y > first.height)
        return Error{ErrorKind::usage,
                     fmt::format("{}: the corner {:g},{:g} is outside the {} x {} pixels",
                                 words({"rectify", ""}), x, y, first.width, first.height)};
    if (Result<void> made = rectify(maps, *use.corners); !made)
      return made.error();
    part.corners = use.corners;
    part.widthShare = maps.front().width / width;
  }
  if (!findsRegularity)
    return part;
  Result<Regularity> regularity = regularityOf(maps, periodic);
  if (!regularity)
    return regularity.error();
  part.regularity = regularity.value();
  if (!use.isAutomatic || !part.regularity.wholePeriods)
    return part;
  part.corners = part.regularity.wholePeriods;
  if (Result<void> made = rectify(maps, *part.corners); !made)
    return made.error();
  part.widthShare = maps.front().width / width;
  const Distortion distortion = distortionOf(*part.corners);
  notes.push_back(fmt::format(
      "the tile is the part of {} x {} pixels that holds whole periods{}; "
      "{} keeps the whole picture{}",
      maps.front().width, maps.front().height, wordsFor(distortion), words({"rectify", "off"}),
      distortion.isDoubtful() ? "; this is at the limit of what is found, so check the tile: if "
                                "it is wrong, give its four corners to " +
                                    words({"rectify", ""})
                              : ""));
  return part;
}

} // namespace lichen
