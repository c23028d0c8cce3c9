// SPDX-License-Identifier: MIT
// Maps -> maps without slow variation, and notes.
#include "prepared_maps.h"

#include <lichen/exemplar_repair.h>

#include <fmt/format.h>

#include <algorithm>

namespace lichen {
namespace {

std::string flattenedNote(const Flattened& flattened, std::size_t maps, SettingWords words) {
  std::vector<std::string_view> names;
  for (const MapTarget map : flattened.maps)
    names.push_back(nameOf(map));
  return fmt::format("{} removes variation slower than {:.0f} pixels{}", words({"flatten", ""}),
                     flattened.periodPixels,
                     names.size() < maps ? fmt::format(" from {}", fmt::join(names, ", ")) : "");
}

std::string sentenceOn(const RemovedLight& light, SettingWords words) {
  return fmt::format("uneven light, from {:.0f} to {:.0f} % of its mean, is removed from the base "
                     "colour; {} keeps it",
                     100.0 * light.darkest, 100.0 * light.brightest, words({"flatten", "none"}));
}

} // namespace

Result<Flattened> applyFlattening(std::vector<MapExemplar>& maps, const Flattening& requested,
                                  Periodic periodic, const BakeObserver& observer,
                                  std::vector<std::string>& notes) {
  if (!requested.isWanted())
    return Flattened{};
  if (requested.automatic && maps.front().target != MapTarget::baseColor)
    return Flattened{};
  const bool fit = bordersFit(maps, periodic);
  const Progress progress = observer.of("flatten");
  if (!requested.automatic) {
    const auto isWanted = [&](MapTarget map) { // flatten() does not change opacity
      return requested.maps.empty() ? map != MapTarget::opacity
                                    : std::ranges::count(requested.maps, map) > 0;
    };
    Flattened flattened{{}, requested.periodPixels};
    for (const MapExemplar& map : maps)
      if (isWanted(map.target))
        flattened.maps.push_back(map.target);
    if (flattened.maps.empty() && requested.maps.empty())
      notes.push_back(observer.words({"flatten", ""}) +
                      " removes nothing: it does not change opacity");
    if (flattened.maps.empty())
      return flattened;
    notes.push_back(flattenedNote(flattened, maps.size(), observer.words));
    if (Result<void> done = flatten(maps, requested.periodPixels, fit, flattened.maps, progress);
        !done)
      return done.error();
    return flattened;
  }
  const Result<std::optional<RemovedLight>> light = removeUnevenLight(maps.front(), fit, progress);
  if (!light)
    return light.error();
  if (!light.value())
    return Flattened{};
  notes.push_back(sentenceOn(*light.value(), observer.words));
  return Flattened{{MapTarget::baseColor}, light.value()->periodPixels};
}

} // namespace lichen
