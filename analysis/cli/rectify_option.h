// SPDX-License-Identifier: MIT
// The option --rectify: makes a part of the exemplar the tile.
#pragma once

#include "options.h"

#include <lichen/exemplar.h>
#include <lichen/result.h>
#include <lichen/structure.h>

#include <optional>
#include <string>
#include <vector>

namespace lichen::cli {

struct Rectification {
  bool isAutomatic = false;           ///< whole periods, where something repeats clearly
  std::optional<TileCorners> corners; ///< as given, or recorded
};

/// "off", or "X,Y,X,Y,X,Y,X,Y", the corners, commas or spaces between them; "auto" too if
/// `findsPeriods`.
[[nodiscard]] Accepted<Rectification> rectification(bool findsPeriods);

/// What was made the tile, and what repeats in it.
struct RectifiedPart {
  std::optional<TileCorners> corners;
  Structure structure;     ///< if that was to be found
  double widthShare = 1.0; ///< width of the first map over what it was
};

/// Replaces the maps by their part between `use.corners`; or, if that is automatic and
/// `findsStructure`, by the whole periods of what repeats, if there are any. Adds a note on what it
/// did. Errors: usage for corners outside the first map; resources.
[[nodiscard]] Result<RectifiedPart> applyRectification(std::vector<MapExemplar>& maps,
                                                       const Rectification& use, Periodic periodic,
                                                       bool findsStructure,
                                                       std::vector<std::string>& notes);

} // namespace lichen::cli
