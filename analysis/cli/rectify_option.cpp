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

/// How a part lies in the picture. [degrees]
struct Slant {
  double rotation = 0.0, shear = 0.0;
  double perspective = 0.0; ///< the larger angle between two opposite sides
};

Slant slantOf(const TileCorners& corners) {
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

/// ", turned by 3.1 degrees, sheared by 0.5 degrees", as far as that is to be seen.
std::string wordsFor(const Slant& slant) {
  constexpr double kVisible = 0.25; // degrees
  std::vector<std::string> words;
  if (std::abs(slant.rotation) > kVisible)
    words.push_back(fmt::format("turned by {:.1f} degrees", slant.rotation));
  if (std::abs(slant.shear) > kVisible)
    words.push_back(fmt::format("sheared by {:.1f} degrees", slant.shear));
  if (slant.perspective > kVisible)
    words.emplace_back("seen in perspective");
  return words.empty() ? "" : fmt::format(", {}", fmt::join(words, ", "));
}

/// Whether other vectors of the lattice may have been taken for its rows and columns. The limits
/// lie in the middle between pictures rotated by 10 or sheared by 5 degrees, of which the right
/// vectors are found (docs/decisions/039-quilting.md), and one rotated by 14, which came out
/// sheared by 7.
bool isDoubtful(const Slant& slant) {
  constexpr double kMostRotation = 12.0, kMostShear = 6.0; // degrees
  return std::abs(slant.rotation) > kMostRotation || std::abs(slant.shear) > kMostShear;
}

} // namespace

Accepted<Rectification> rectification() {
  return {
      "auto|off|X,Y,...",
      "auto, off, or eight numbers: X,Y in pixels of the upper left, upper right, lower right and "
      "lower left corner, which must be convex",
      [](const std::string& text) -> std::optional<Rectification> {
        if (text == "auto")
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
  const Slant slant = slantOf(*part.corners);
  notes.push_back(fmt::format(
      "the tile is the part of {} x {} pixels that holds whole periods{}; {}", maps.front().width,
      maps.front().height, wordsFor(slant),
      isDoubtful(slant)
          ? "angles as large as these may be wrong: if rows of the bake slope, give the "
            "corners to --rectify"
          : "--rectify off keeps the whole picture"));
  return part;
}

} // namespace lichen::cli
