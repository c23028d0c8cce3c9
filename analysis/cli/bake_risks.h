// SPDX-License-Identifier: MIT
// The risks that a bake reports before it starts, and the flattening that removes some of them.
#pragma once

#include "command.h"
#include "options.h"

#include <lichen/exemplar.h>
#include <lichen/suitability.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// --flatten none|auto|PERIOD.
struct Flattening {
  bool automatic = false;
  double periodPixels = 0.0;   ///< pixels of the first map; 0 for none
  std::vector<MapTarget> maps; ///< that are flattened by it; empty: all but opacity

  [[nodiscard]] bool isWanted() const { return automatic || periodPixels > 0.0; }
};
[[nodiscard]] Accepted<Flattening> flattening();

/// The flattened maps, and the cut-off period in pixels of the first map.
struct Flattened {
  std::vector<MapTarget> maps;
  double periodPixels = 0.0;
};

/// Flattens the maps as --flatten asks. `auto` calls removeUnevenLight() for the base colour. Adds
/// a sentence to `notes` that says what was removed.
[[nodiscard]] Result<Flattened> applyFlattening(std::vector<MapExemplar>& maps,
                                                const Flattening& requested, Periodic periodic,
                                                const SharedOptions& options,
                                                std::vector<std::string>& notes);

/// A risk, and the map where it is greatest.
struct MapRisk {
  MapTarget map{};
  Risk risk;
};

/// Returns each risk once, for the map where its level is highest. On a tie the first map wins: it
/// is the base colour if there is one, which people see first.
[[nodiscard]] std::vector<MapRisk> leadingRisks(std::span<const MapExemplar> maps,
                                                std::span<const std::vector<Risk>> risks);

/// An option of `lichen bake`: "--flatten 128".
[[nodiscard]] std::string optionOf(const BakeSetting& setting);

/// One line for each risk above level none; names the map if `severalMaps`.
[[nodiscard]] std::vector<std::string> riskNotes(std::span<const MapRisk> risks, bool severalMaps,
                                                 SettingWords words = optionOf);

/// All risks of a bake, including risks of level none.
[[nodiscard]] nlohmann::ordered_json risksAsJson(std::span<const MapRisk> risks);

} // namespace lichen::cli
