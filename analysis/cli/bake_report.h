// SPDX-License-Identifier: MIT
// The closing report of `lichen bake`.
#pragma once

#include "bake_risks.h"
#include "command.h"

#include <lichen/bundle.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace lichen::cli {

/// A successful bake.
struct BakeOutcome {
  std::string output;
  const Bundle& bundle; ///< its first noise is the result; layers and index maps follow
  std::vector<std::string> notes;
  Verdict verdict;
  std::vector<MapRisk> risks;
  const nlohmann::ordered_json& ofMethod; ///< JSON members of the method
  double seconds = 0.0;
};

/// Prints two lines to standard output, the verdict and the file, or one JSON object with --json.
void reportBake(const SharedOptions& options, const BakeOutcome& outcome);

} // namespace lichen::cli
