// SPDX-License-Identifier: MIT
// Maps -> maps without outliers, and notes.
#include "prepared_maps.h"

#include <lichen/exemplar_repair.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// Column, row, width and height in whole pixels.
using Place = std::array<long, 4>;

/// A place of the first map in pixels of the photograph.
Place inPhotograph(const std::array<std::uint32_t, 4>& place, const MapExemplar& first,
                   const std::optional<PhotographPart>& part) {
  const auto [x, y, width, height] =
      part.value_or(PhotographPart{0.0, 0.0, double(first.width), double(first.height)});
  const double across = width / first.width, down = height / first.height;
  return {std::lround(x + across * place[0]), std::lround(y + down * place[1]),
          std::lround(across * place[2]), std::lround(down * place[3])};
}

/// The largest rectangle of the photograph beside the place.
Place cropBeside(const Place& place, const PhotographPart& part) {
  const long left = std::lround(part[0]), top = std::lround(part[1]);
  const long width = std::lround(part[2]), height = std::lround(part[3]);
  const long right = place[0] + place[2], bottom = place[1] + place[3];
  const std::array<Place, 4> beside{{{left, top, place[0] - left, height},
                                     {right, top, left + width - right, height},
                                     {left, top, width, place[1] - top},
                                     {left, bottom, width, top + height - bottom}}};
  return *std::ranges::max_element(beside, {}, [](const Place& crop) { return crop[2] * crop[3]; });
}

std::string wordsFor(const Place& place) {
  return fmt::format("the part at {},{}, {} x {} pixels, occurs once", place[0], place[1], place[2],
                     place[3]);
}

} // namespace

Result<std::vector<FilledPlace>> applyOutliers(std::vector<MapExemplar>& maps,
                                               const OutlierUse& use, Periodic borders,
                                               const std::optional<PhotographPart>& part,
                                               const BakeObserver& observer,
                                               std::vector<std::string>& notes) {
  if (use.recorded && use.recorded->empty())
    return std::vector<FilledPlace>{};
  if (use.recorded) {
    const bool fit = bordersFit(maps, borders);
    if (Result<void> done = fillPlaces(maps, *use.recorded, fit); !done)
      return done.error();
    return *use.recorded;
  }
  const MapExemplar& first = maps.front();
  if (use.keeps || first.target != MapTarget::baseColor ||
      std::ranges::count(maps, MapTarget::opacity, &MapExemplar::target) > 0)
    return std::vector<FilledPlace>{};
  Result<Outliers> outliers =
      fillOutliers(maps, bordersFit(maps, borders), observer.of("outliers"));
  if (!outliers)
    return outliers.error();
  for (const FilledPlace& filled : outliers.value().filled)
    notes.push_back(wordsFor(inPhotograph(filled.place, first, part)) +
                    " and is filled from the rest; " + observer.words({"keep-outliers", ""}) +
                    " keeps it");
  if (const auto& left = outliers.value().left) {
    const Place place = inPhotograph(*left, first, part);
    std::string note = wordsFor(place) + " and is too large to fill: the noise will repeat it";
    if (part) {
      const Place crop = cropBeside(place, *part);
      if (4 * crop[2] >= std::lround((*part)[2]) && 4 * crop[3] >= std::lround((*part)[3]))
        note += fmt::format("; {} leaves it out",
                            observer.words({"crop", fmt::format("{}", fmt::join(crop, ","))}));
    }
    notes.push_back(std::move(note));
  }
  return std::move(outliers.value().filled);
}

} // namespace lichen
