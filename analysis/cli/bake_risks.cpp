// SPDX-License-Identifier: MIT
// Maps -> flattened maps, and their risks as notes and JSON.
#include "bake_risks.h"

#include "progress_line.h"

#include <lichen/flatten.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::cli {

Accepted<Flattening> flattening() {
  const Accepted<double> period = number(kFlattenPeriodRange);
  return {"none|auto|PERIOD", "none, auto or " + period.sentence,
          [read = period.read](const std::string& text) -> std::optional<Flattening> {
            if (text == "none")
              return Flattening{};
            if (text == "auto")
              return Flattening{true, 0.0, {}};
            const std::optional<double> pixels = read(text);
            return pixels ? std::optional(Flattening{false, *pixels, {}}) : std::nullopt;
          }};
}

namespace {

std::string flattenedNote(const Flattened& flattened, std::size_t maps) {
  std::vector<std::string_view> names;
  for (const MapTarget map : flattened.maps)
    names.push_back(nameOf(map));
  return fmt::format("--flatten removes variation slower than {:.0f} pixels{}",
                     flattened.periodPixels,
                     names.size() < maps ? fmt::format(" from {}", fmt::join(names, ", ")) : "");
}

std::string sentenceOn(const RemovedLight& light) {
  return fmt::format("uneven light, from {:.0f} to {:.0f} % of its mean, is removed from the base "
                     "colour; --flatten none keeps it",
                     100.0 * light.darkest, 100.0 * light.brightest);
}

} // namespace

Result<Flattened> applyFlattening(std::vector<MapExemplar>& maps, const Flattening& requested,
                                  Periodic periodic, const SharedOptions& options,
                                  std::vector<std::string>& notes) {
  if (!requested.isWanted())
    return Flattened{};
  if (requested.automatic && maps.front().target != MapTarget::baseColor)
    return Flattened{};
  const bool fit = bordersFit(maps, periodic);
  ProgressLine line("flatten", options);
  const Progress progress = line.asProgress();
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
      notes.emplace_back("--flatten removes nothing: it does not change opacity");
    if (flattened.maps.empty())
      return flattened;
    notes.push_back(flattenedNote(flattened, maps.size()));
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
  notes.push_back(sentenceOn(*light.value()));
  return Flattened{{MapTarget::baseColor}, light.value()->periodPixels};
}

std::vector<MapRisk> leadingRisks(std::span<const MapExemplar> maps,
                                  std::span<const std::vector<Risk>> risks) {
  std::vector<MapRisk> leading;
  for (const Risk& risk : risks.front())
    leading.push_back({maps.front().target, risk});
  for (std::size_t k = 0; k < leading.size(); ++k)
    for (std::size_t m = 1; m < maps.size(); ++m)
      if (const Risk& risk = risks[m][k]; risk.level > leading[k].risk.level)
        leading[k] = {maps[m].target, risk};
  return leading;
}

std::string optionOf(const BakeSetting& setting) {
  return fmt::format("--{} {}", setting.name, setting.value);
}

std::vector<std::string> riskNotes(std::span<const MapRisk> risks, bool severalMaps,
                                   SettingWords words) {
  std::vector<std::string> notes;
  for (const auto& [map, risk] : risks)
    if (risk.level != Risk::Level::none)
      notes.push_back(fmt::format("{} ({}{}): {}; what helps: {}", risk.name, nameOf(risk.level),
                                  severalMaps ? fmt::format(", {}", nameOf(map)) : "",
                                  risk.sentence, remedyOf(risk, words)));
  return notes;
}

nlohmann::ordered_json risksAsJson(std::span<const MapRisk> risks) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& [map, risk] : risks)
    json.push_back({{"map", nameOf(map)},
                    {"name", risk.name},
                    {"score", risk.score},
                    {"level", nameOf(risk.level)},
                    {"sentence", risk.sentence},
                    {"remedy", remedyOf(risk, optionOf)}});
  return json;
}

} // namespace lichen::cli
