// SPDX-License-Identifier: MIT
// What a bake says of its exemplar before it begins, and what it does about it if told to.
#pragma once

#include "command.h"
#include "options.h"

#include <lichen/exemplar.h>
#include <lichen/suitability.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// --flatten none|auto|PERIOD.
struct Flattening {
  bool automatic = false;
  double periodPixels = 0.0; ///< of the first map; 0 for none

  [[nodiscard]] bool isWanted() const { return automatic || periodPixels > 0.0; }
};
[[nodiscard]] Accepted<Flattening> flattening();

/// The maps that were flattened, and by which period, pixels of the first map.
struct Flattened {
  std::vector<MapTarget> maps;
  double periodPixels = 0.0;
};

/// Flattens the maps as told; `auto` as flattenAutomatically(). What was done, or why nothing, is
/// in a sentence of `notes`.
[[nodiscard]] Result<Flattened> flattenAsTold(std::vector<MapExemplar>& maps,
                                              const Flattening& told, Periodic periodic,
                                              const SharedOptions& options,
                                              std::vector<std::string>& notes);

using AssessMap =
    std::function<Result<std::vector<Risk>>(const MapExemplar& map, const Progress& progress)>;
/// The risks of each map by `assess`, in their order, with a progress line.
[[nodiscard]] Result<std::vector<std::vector<Risk>>> assessEach(std::span<const MapExemplar> maps,
                                                                const SharedOptions& options,
                                                                const AssessMap& assess);

/// A risk and the map that runs it most.
struct MapRisk {
  MapTarget map{};
  Risk risk;
};

/// Each risk once: as the first map has it, the base colour if there is one, which is what people
/// see; or as another has it of the highest level, where that is above the first one's.
[[nodiscard]] std::vector<MapRisk> leadingRisks(std::span<const MapExemplar> maps,
                                                std::span<const std::vector<Risk>> risks);

/// A line for each risk that is one; with the map's name where there are several.
[[nodiscard]] std::vector<std::string> riskNotes(std::span<const MapRisk> risks, bool severalMaps);

/// All of them.
[[nodiscard]] nlohmann::ordered_json risksAsJson(std::span<const MapRisk> risks);

} // namespace lichen::cli
