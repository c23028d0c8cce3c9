// SPDX-License-Identifier: MIT
// Maps -> flattened maps, and their risks as notes and JSON.
#include "bake_risks.h"

#include <lichen/flatten.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace lichen::cli {

Accepted<Flattening> flattening() {
  const Accepted<double> period = number(kFlattenPeriodRange);
  return {"none|auto|PERIOD", "none, auto or " + period.sentence,
          [read = period.read](const std::string& text) -> std::optional<Flattening> {
            if (text == "none")
              return Flattening{};
            if (text == "auto")
              return Flattening{true, 0.0};
            const std::optional<double> pixels = read(text);
            return pixels ? std::optional(Flattening{false, *pixels}) : std::nullopt;
          }};
}

Result<void> flattenAsTold(std::vector<MapExemplar>& maps, const Flattening& told,
                           Periodic periodic, std::vector<std::string>& notes) {
  const bool fit = bordersFit(maps, periodic);
  double period = told.periodPixels;
  if (told.automatic) {
    const Result<std::optional<double>> calming = flatteningPeriod(maps.front(), fit);
    if (!calming)
      return calming.error();
    period = calming.value().value_or(0.0);
  }
  if (period == 0.0) {
    if (told.automatic)
      notes.push_back("there is nothing that flattening would mend; nothing is removed");
    return {};
  }
  notes.push_back(fmt::format("variation slower than {:.0f} pixels is removed", period));
  return flatten(maps, period, fit);
}

Result<std::vector<MapRisk>> worstRisks(std::span<const MapExemplar> maps, bool periodic) {
  std::vector<MapRisk> worst;
  for (const MapExemplar& map : maps) {
    const Result<std::vector<Risk>> risks = assessSuitability(map, periodic);
    if (!risks)
      return risks.error();
    for (std::size_t k = 0; k < risks.value().size(); ++k) {
      const Risk& risk = risks.value()[k];
      if (k == worst.size())
        worst.push_back({map.target, risk});
      else if (risk.score > worst[k].risk.score)
        worst[k] = {map.target, risk};
    }
  }
  return worst;
}

std::vector<std::string> riskNotes(std::span<const MapRisk> risks, bool severalMaps) {
  std::vector<std::string> notes;
  for (const auto& [map, risk] : risks)
    if (risk.level != Risk::Level::none)
      notes.push_back(fmt::format("{} ({}{}): {}; what helps: {}", risk.name, nameOf(risk.level),
                                  severalMaps ? fmt::format(", {}", nameOf(map)) : "",
                                  risk.sentence, risk.remedy));
  return notes;
}

nlohmann::ordered_json risksAsJson(std::span<const MapRisk> risks) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& [map, risk] : risks)
    json.push_back({{"name", risk.name},
                    {"map", nameOf(map)},
                    {"score", risk.score},
                    {"level", nameOf(risk.level)},
                    {"sentence", risk.sentence},
                    {"remedy", risk.remedy}});
  return json;
}

} // namespace lichen::cli
