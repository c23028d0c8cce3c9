// SPDX-License-Identifier: MIT
// What `lichen bake` says when it is done.
#pragma once

#include "bake_risks.h"
#include "command.h"

#include <lichen/bundle.h>
#include <lichen/precision_loss.h>
#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// A bake that succeeded.
struct BakeOutcome {
  std::string output;
  const Bundle& bundle; ///< of one noise
  bool exemplarWasPeriodic = true;
  std::optional<PrecisionLoss> precisionLoss; ///< of the first map of a tiling noise, with --json
  std::vector<std::string> notes;
  std::vector<MapRisk> risks;
  std::vector<MapTransportBound> transportBounds;
  std::optional<TextonQuality> texton;
  double seconds = 0.0;
};

/// A line for each map whose transport is certified, with the worst of its bounds.
[[nodiscard]] std::vector<std::string> certificateNotes(std::span<const MapTransportBound> bounds);

/// One line, or with --json one object, on standard output.
void reportBake(const SharedOptions& options, const BakeOutcome& outcome);

} // namespace lichen::cli
