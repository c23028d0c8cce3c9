// SPDX-License-Identifier: MIT
// The steps of prepareExemplar(). Each adds a sentence on what it did to `notes`.
#pragma once

#include <lichen/exemplar_preparation.h>

#include <array>

namespace lichen {

/// The flattened maps, and the cut-off period in pixels of the first map.
struct Flattened {
  std::vector<MapTarget> maps;
  double periodPixels = 0.0;
};
[[nodiscard]] Result<Flattened> applyFlattening(std::vector<MapExemplar>& maps,
                                                const Flattening& requested, Periodic periodic,
                                                const BakeObserver& observer,
                                                std::vector<std::string>& notes);

/// The part of the largest file that became the exemplar: column, row, width and height.
using PhotographPart = std::array<double, 4>;

/// Returns what was filled. Without a `part`, places in notes are in pixels of the first map.
[[nodiscard]] Result<std::vector<FilledPlace>>
applyOutliers(std::vector<MapExemplar>& maps, const OutlierUse& use, Periodic borders,
              const std::optional<PhotographPart>& part, const BakeObserver& observer,
              std::vector<std::string>& notes);

/// What was made the tile, and what repeats in it.
struct RectifiedPart {
  std::optional<TileCorners> corners;
  Regularity regularity;   ///< if that was to be found
  double widthShare = 1.0; ///< width of the first map over what it was
};
[[nodiscard]] Result<RectifiedPart> applyRectification(std::vector<MapExemplar>& maps,
                                                       const Rectification& use, Periodic periodic,
                                                       bool findsRegularity, SettingWords words,
                                                       std::vector<std::string>& notes);

} // namespace lichen
