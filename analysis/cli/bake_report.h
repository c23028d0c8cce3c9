// SPDX-License-Identifier: MIT
// What `lichen bake` says when it is done.
#pragma once

#include "bake_risks.h"
#include "command.h"

#include <lichen/bundle.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace lichen::cli {

/// A bake that succeeded.
struct BakeOutcome {
  std::string output;
  const Bundle& bundle; ///< of one noise
  std::vector<std::string> notes;
  std::vector<MapRisk> risks;
  const nlohmann::ordered_json& ofMethod; ///< members that the method adds
  double seconds = 0.0;
};

/// One line, or with --json one object, on standard output.
void reportBake(const SharedOptions& options, const BakeOutcome& outcome);

} // namespace lichen::cli
