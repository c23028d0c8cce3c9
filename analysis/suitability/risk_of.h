// SPDX-License-Identifier: MIT
// A score and what was measured -> a risk in words.
#pragma once

#include <lichen/suitability.h>

#include <string>
#include <string_view>

namespace lichen::suitability {

/// What is measured is said of every exemplar, what comes of it and helps where it is a risk.
[[nodiscard]] Risk riskOf(std::string_view name, double score, const std::string& measured,
                          const std::string& consequence, std::string remedy);

/// "12 %" of 0.12.
[[nodiscard]] std::string percent(double share);

} // namespace lichen::suitability
