// SPDX-License-Identifier: MIT
// Describes a risk in words, from its score and measure.
#pragma once

#include <lichen/suitability.h>

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

/// "12 %" for 0.12.
[[nodiscard]] std::string percent(double share);

} // namespace lichen::suitability
