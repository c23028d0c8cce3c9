// SPDX-License-Identifier: MIT
// Describes a risk in words, from its score and measure, and runs an assessment.
#pragma once

#include <lichen/suitability.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lichen::suitability {

/// What helps against a risk.
struct Remedy {
  std::vector<BakeSetting> settings{};
  std::string advice{};
};

/// The text always contains `measured`; it contains `consequence`, and the risk has the remedy,
/// only if the score is a risk.
[[nodiscard]] Risk riskOf(std::string_view name, double score, const std::string& measured,
                          const std::string& consequence, Remedy remedy);

/// Returns the risks that `judge` finds, after checking that the map's values are in range. `judge`
/// may throw Interrupted and std::bad_alloc, which become errors.
[[nodiscard]] Result<std::vector<Risk>> assessed(const MapExemplar& map,
                                                 const std::function<std::vector<Risk>()>& judge);

/// "12 %" for 0.12.
[[nodiscard]] std::string percent(double share);

} // namespace lichen::suitability
