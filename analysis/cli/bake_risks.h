// SPDX-License-Identifier: MIT
// What a bake says of its exemplar before it begins, and what it does about it if told to.
#pragma once

#include "options.h"

#include <lichen/suitability.h>
#include <lichen/tiling.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// --flatten none|auto|PERIOD.
struct Flattening {
  bool automatic = false;
  double periodPixels = 0.0; ///< of the first map; 0 for none
};
[[nodiscard]] Accepted<Flattening> flattening();

/// Flattens the maps as told; `auto` by what the first of them needs. The period that was taken is
/// in a sentence of `notes`.
[[nodiscard]] Result<void> flattenAsTold(std::vector<MapExemplar>& maps, const Flattening& told,
                                         Periodic periodic, std::vector<std::string>& notes);

/// A risk and the map that runs it most.
struct MapRisk {
  MapTarget map{};
  Risk risk;
};

/// Each risk once, as the map has it that scores worst.
[[nodiscard]] Result<std::vector<MapRisk>> worstRisks(std::span<const MapExemplar> maps,
                                                      bool periodic);

/// A line for each risk that is one; with the map's name where there are several.
[[nodiscard]] std::vector<std::string> riskNotes(std::span<const MapRisk> risks, bool severalMaps);

/// All of them.
[[nodiscard]] nlohmann::ordered_json risksAsJson(std::span<const MapRisk> risks);

} // namespace lichen::cli
