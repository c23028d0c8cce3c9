// SPDX-License-Identifier: MIT
// The maps of a material -> the exemplar to bake: flattened, filled and straightened, with a record
// of it, so that a comparison makes exactly the same exemplar again.
#pragma once

#include <lichen/material_set.h>
#include <lichen/noise_report.h>
#include <lichen/progress.h>
#include <lichen/regularity.h>
#include <lichen/suitability.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// How a caller follows a bake. Functions are called on the thread that called the bake, and may be
/// empty. They must not throw.
struct BakeObserver {
  /// The step under way, such as "outliers", "bake" or "judge", and its finished share, as Progress
  /// has it, first 0. Returns whether to continue.
  std::function<bool(std::string_view step, double fraction)> progress;
  /// A sentence for the user, as soon as it is known.
  std::function<void(const std::string& line)> note;
  /// Puts settings that a sentence names into the words of the program.
  SettingWords words = plainWords;

  /// Begins a step and returns its progress. This object must outlive it.
  [[nodiscard]] Progress of(std::string_view step) const {
    if (!progress)
      return {};
    progress(step, 0.0); // what it returns counts from the next call on
    return [this, step](double fraction) { return progress(step, fraction); };
  }
};

/// The removal of slow variation.
struct Flattening {
  bool automatic = false;    ///< of uneven light from the base colour, if the noise would show it
  double periodPixels = 0.0; ///< pixels of the first map; 0 for none
  std::vector<MapTarget> maps{}; ///< that are flattened by it; empty: all but opacity

  [[nodiscard]] bool isWanted() const { return automatic || periodPixels > 0.0; }
};

/// What happens to parts of an exemplar that occur once.
struct OutlierUse {
  bool keeps = false;
  std::optional<std::vector<FilledPlace>> recorded{}; ///< to fill exactly these
};

/// The part of the exemplar that becomes the tile; all of it by default.
struct Rectification {
  bool isAutomatic = false;             ///< whole periods, where something repeats clearly
  std::optional<TileCorners> corners{}; ///< as given, or recorded; pixels of the first map
};

/// How the exemplar is made from its maps. The defaults are a bake's.
struct ExemplarOptions {
  MaterialSetOptions set{}; ///< with which the maps were read
  Flattening flattening{.automatic = true};
  OutlierUse outliers{};
  Rectification rectification{.isAutomatic = true};
  bool keepsOriginals = false; ///< whether to return the maps before flattening and filling
};

/// An exemplar, and how each of its maps was made.
struct PreparedExemplar {
  MaterialSet set;
  std::vector<ExemplarOrigin> origins; ///< one per map
  Preparation preparation;             ///< what the options came to
  Regularity regularity;               ///< if that was to be found
  double widthShare = 1.0;             ///< of the first map, over what it was before
};

/// Flattens, fills and rectifies the maps as the options ask, and adds sentences on it to the notes
/// of the set; `observer` hears of progress only. `findsRegularity` says whether to measure what
/// repeats, as automatic rectification needs. Outliers are filled if the first map is a base colour
/// and none is opacity, whose shape is the material. Errors: usage for corners outside the first
/// map; as flatten(), fillOutliers() and regularityOf().
[[nodiscard]] Result<PreparedExemplar> prepareExemplar(MaterialSet set,
                                                       const ExemplarOptions& options,
                                                       bool findsRegularity,
                                                       const BakeObserver& observer = {});

} // namespace lichen
