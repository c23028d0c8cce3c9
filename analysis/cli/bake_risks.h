// SPDX-License-Identifier: MIT
// The risks of a noise and the verdict on it, in words and JSON.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/noise_verdict.h>

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// A risk, and the map where it is greatest.
struct MapRisk {
  MapTarget map{};
  Risk risk;
};

/// Returns each risk once, for the map where its level is highest. On a tie the first map wins: it
/// is the base colour if there is one, which people see first.
[[nodiscard]] std::vector<MapRisk> leadingRisks(std::span<const MapExemplar> maps,
                                                std::span<const std::vector<Risk>> risks);

/// An option of `lichen bake`: "--flatten 128", or "--flatten".
[[nodiscard]] std::string optionOf(const BakeSetting& setting);

/// One line for each risk above level none; names the map if `severalMaps`.
[[nodiscard]] std::vector<std::string> riskNotes(std::span<const MapRisk> risks, bool severalMaps,
                                                 SettingWords words = optionOf);

/// All risks of a bake, including risks of level none.
[[nodiscard]] nlohmann::ordered_json risksAsJson(std::span<const MapRisk> risks);

/// The line to print: "verdict: good".
[[nodiscard]] std::string verdictLine(const Verdict& verdict, bool severalMaps);

/// {"level", "map", "risk", "score", "sentence"}.
[[nodiscard]] nlohmann::ordered_json jsonOf(const Verdict& verdict);

} // namespace lichen::cli
