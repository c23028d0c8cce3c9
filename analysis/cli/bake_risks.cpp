// SPDX-License-Identifier: MIT
// Risks and a verdict -> notes and JSON.
#include "bake_risks.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::cli {

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

std::string optionOf(const BakeSetting& setting) { return "--" + plainWords(setting); }

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

std::string verdictLine(const Verdict& verdict, bool severalMaps) {
  return "verdict: " + sentenceOf(verdict, severalMaps, optionOf);
}

nlohmann::ordered_json jsonOf(const Verdict& verdict) {
  return {{"level", nameOf(verdict.level)},
          {"map", nameOf(verdict.map)},
          {"risk", verdict.worst.name},
          {"score", verdict.worst.score},
          {"sentence", sentenceOf(verdict, true, optionOf)}};
}

} // namespace lichen::cli
