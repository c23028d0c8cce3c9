// SPDX-License-Identifier: MIT
// Describes a risk in words, from its score and measure, and runs an assessment.
#pragma once

#include "exemplar/map_ranges.h"
#include "progress_part.h"

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

/// Returns the risks that `judge` finds, after checking that the map's values are in range. `judge`
/// may throw Interrupted and std::bad_alloc, which become errors.
template <class Judge>
[[nodiscard]] Result<std::vector<Risk>> assessed(const MapExemplar& map, const Judge& judge) {
  const auto exhausted = [&] {
    return "not enough memory to assess " + std::to_string(map.width) + " x " +
           std::to_string(map.height) + " pixels";
  };
  return withinMemory(exhausted, [&]() -> Result<std::vector<Risk>> {
    if (Result<void> checked = exemplar::checkRanges(map); !checked)
      return checked.error();
    return unlessInterrupted("the assessment",
                             [&]() -> Result<std::vector<Risk>> { return judge(); });
  });
}

/// "12 %" for 0.12.
[[nodiscard]] std::string percent(double share);

} // namespace lichen::suitability
